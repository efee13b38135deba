// OpenCL's C++ binding as this project uses it: exceptions on, 1.2 as the least that a driver must offer.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/opencl.hpp>
#include <string>
#include <vector>

#include "device.h"

namespace gnomon {

/// The driver's handle for a listed device.
cl::Device open_device(const DeviceInfo& info);

/// The device that a part is of, and the equal parts of one, described as list_devices() would. Throw cl::Error.
DeviceInfo whole_of(const DeviceInfo& part);
std::vector<DeviceInfo> parts_of(const DeviceInfo& whole, int parts);

/// The equal parts of a device, of so many compute units each, in order. Each is made once.
std::vector<cl::Device> equal_parts(const cl::Device& device, int units);

/// "clBuildProgram failed: CL_OUT_OF_RESOURCES (-5)"
std::string describe(const cl::Error& error);

}  // namespace gnomon
