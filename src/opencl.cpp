#include "opencl.h"

#include <map>

namespace gnomon {

namespace {

/// The errors that a launch, a build or an allocation can end with; cl.h has no names at run time.
const char* name_of(cl_int code) {
#define CODE(c) \
    { c, #c }
    static const std::map<cl_int, const char*> names = {CODE(CL_DEVICE_NOT_FOUND),
                                                        CODE(CL_DEVICE_NOT_AVAILABLE),
                                                        CODE(CL_COMPILER_NOT_AVAILABLE),
                                                        CODE(CL_MEM_OBJECT_ALLOCATION_FAILURE),
                                                        CODE(CL_OUT_OF_RESOURCES),
                                                        CODE(CL_OUT_OF_HOST_MEMORY),
                                                        CODE(CL_BUILD_PROGRAM_FAILURE),
                                                        CODE(CL_MAP_FAILURE),
                                                        CODE(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
                                                        CODE(CL_INVALID_VALUE),
                                                        CODE(CL_INVALID_PLATFORM),
                                                        CODE(CL_INVALID_DEVICE),
                                                        CODE(CL_INVALID_QUEUE_PROPERTIES),
                                                        CODE(CL_INVALID_MEM_OBJECT),
                                                        CODE(CL_INVALID_BUILD_OPTIONS),
                                                        CODE(CL_INVALID_KERNEL_NAME),
                                                        CODE(CL_INVALID_ARG_INDEX),
                                                        CODE(CL_INVALID_ARG_VALUE),
                                                        CODE(CL_INVALID_ARG_SIZE),
                                                        CODE(CL_INVALID_KERNEL_ARGS),
                                                        CODE(CL_INVALID_WORK_GROUP_SIZE),
                                                        CODE(CL_INVALID_EVENT_WAIT_LIST),
                                                        CODE(CL_INVALID_BUFFER_SIZE),
                                                        CODE(CL_INVALID_GLOBAL_WORK_SIZE)};
#undef CODE
    const auto found = names.find(code);
    return found == names.end() ? "error" : found->second;
}

}  // namespace

std::string describe(const cl::Error& error) {
    return std::string(error.what()) + " failed: " + name_of(error.err()) + " (" + std::to_string(error.err()) + ")";
}

}  // namespace gnomon
