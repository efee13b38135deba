// PLY files of spheres that are damaged, or lie: each is refused, and told why.
#include "damaged_spheres.h"

using namespace gnomon;
using namespace gnomon::test;

TEST_CASE("damaged PLY headers are refused", "[sphere_io]") {
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const auto with = [&](const std::string& more) { return ply("element vertex 0\n" + xyz + more + "end_header\n"); };
    check_refused(
        "a.ply",
        {
            {"plywood\n", {"found no PLY file: the first line is not \"ply\""}},
            {"plywood" + long_line, {"found no line end within 1 MiB"}},
            {"x" + long_line, {"found no PLY file"}},
            {"ply\n" + long_line, {"line 2: found no line end within 1 MiB"}},
            {ply("comment" + long_line), {"line 3: found no line end within 1 MiB"}},
            {"ply\n", {"the file ends in the header: found no end_header"}},
            {"ply\nformat ascii 2.0\n", {"line 2: found \"format ascii 2.0\", expected \"format\" with ascii,"}},
            {"ply\ncomment first\nelement vertex 0\n", {"line 3: found \"element vertex 0\", expected \"format\""}},
            {"ply\nformat ascii 1.0 x\n", {"line 2: found \"format ascii 1.0 x\", expected \"format\""}},
            {ply("end_header x\n"), {"line 3: found \"end_header x\", expected element"}},
            {ply("elements vertex 2\n"), {"line 3: found \"elements vertex 2\", expected element, property, comment"}},
            {ply("element vertex\n"),
             {"line 3: found \"element vertex\", expected \"element\" with a name and a count"}},
            {ply("element vertex -1\n"), {"expected \"element\" with a name and a count from 0"}},
            {ply("element vertex 1e3\n"), {"expected \"element\" with a name and a count from 0"}},
            {ply("element vertex 99999999999999999999\n"), {"expected \"element\" with a name and a count from 0"}},
            {ply("element vertex 2 3\n"), {"expected \"element\" with a name and a count from 0"}},
            {ply("element vertex 0\n" + xyz + "element vertex 0\n"), {"line 7: found", "expected each element once"}},
            {ply("property float x\n"), {"line 3: found", "expected an element before its properties"}},
            {with("property half w\n"), {"line 7: found", "expected a property's type: char, uchar, short"}},
            {with("property float\n"), {"line 7: found", "expected \"property\" with a type and a name"}},
            {with("property float a b\n"), {"line 7: found", "expected \"property\" with a type and a name"}},
            {with("property float x\n"), {"line 7: found", "expected each property of an element once"}},
            {with("property list float int v\n"), {"line 7: found", "expected an integer type for a list's length"}},
            {with("property list uchar v\n"), {"line 7: found", "expected a property's type"}},
            {with("element face 7\n"), {"element \"face\" has no properties"}},
            {ply("element vertex 2\nend_header\n"), {"element \"vertex\" has no properties"}},
            {ply("element vertex 0\n" + xyz), {"the file ends in the header: found no end_header"}},
            {ply("end_header\n"), {"found no element \"vertex\""}},
            {with(""), {"found no radius: the vertices have none", "{\"file\": ..., \"radius\": ...}"}},
            {ply("element vertex 0\nproperty float x\nend_header\n"), {"found no property \"y\" of the vertices"}},
            {with("property uchar red\nproperty uchar blue\n"), {"found some of red, green and blue, expected all"}},
            {with("property int red\nproperty int green\nproperty int blue\n"),
             {"red: found another type, expected uchar, float or double"}},
            {with("property list uchar float radius\n"), {"radius: found a list, expected a number"}},
            {ply(std::string(5000, 'k') + "\n"), {"line 3: found \"kkk"}},
        });
}

TEST_CASE("damaged PLY data is refused", "[sphere_io]") {
    const std::string bytes = bytes_of(std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8});
    const std::string list = "element face 1\nproperty list int uchar v\nelement vertex 0\n" + vertices;
    check_refused(
        "a.ply",
        {
            {ply(two) + "1.00 2.00 3.00 4.00\n", {"vertex 1: the file ends here"}},
            {ply(two), {"found 0 bytes, too few for 2 of element \"vertex\"", "was the file written to its end?"}},
            {ply(two) + "1 2 3 4\n1 2 3\n", {"vertex 1: the line ends before the last property"}},
            {ply(two) + "1 2 3 4 5\n1 2 3 4\n", {"vertex 0: found \"5\" after the last property"}},
            {ply(two) + "1 2 3 4\n1 2,5 3 4\n",
             {"vertex 1: found y \"2,5\", expected a number from -3.4028234e38 to 3.4028234e38"}},
            {ply(two) + "1 2 3 4\n1 2 3 1e39\n",
             {"vertex 1: found radius \"1e39\", expected a number from -3.4028234e38"}},
            {ply(two) + "1 2 3 4\n1 2 3 +-4\n", {"vertex 1: found radius \"+-4\", expected a number"}},
            {ply(two) + "1 2 3 4\n1 2 3 4\n\n 5\n", {"found 2 bytes after the last element"}},
            {ply(two, little) + bytes.substr(1), {"found 31 bytes, too few for 2 of element \"vertex\""}},
            {ply(two, little) + bytes + "xy", {"found 2 bytes after the last element"}},
            {ply("element vertex 2147483648\n" + vertices), {"too few for 2147483648 of element \"vertex\""}},
            {ply("element vertex 9223372036854775807\n" + vertices, little) + bytes, {"found 32 bytes, too few for"}},
            {ply("element face 9223372036854775807\nproperty list uchar int v\n" + two, little) + bytes,
             {"found 32 bytes, too few for 9223372036854775807 of element \"face\""}},
            {ply(list, little) + bytes_of(int32_t{-1}), {"face 0: found a list of -1 items"}},
            {ply(list, little) + bytes_of(int32_t{2}) + "x", {"face 0: the file ends here"}},
            {ply(list, little) + bytes_of(int32_t{0x7FFFFFFF}), {"face 0: the file ends here"}},
            {ply(list) + "-1\n", {"face 0: found a list of -1 items"}},
            {ply(list) + "2 0 256\n", {"face 0: found v \"256\", expected an integer from 0 to 255"}},
            {ply(list) + "3 0 1\n", {"face 0: the line ends before the last property"}},
            {ply(list) + "x\n", {"face 0: found v \"x\", expected an integer from -2147483648 to 2147483647"}},
        });
}

TEST_CASE("words of a PLY file that its types cannot hold are refused", "[sphere_io]") {
    const auto check = [&](const std::string& type, const std::string& word, const std::string& expected) {
        const std::string message = "vertex 1: found w \"" + word + "\", expected " + expected;
        const std::string head = "property " + type + " w\n" + vertices;  // skipped, and checked as those that are used
        const std::string zero = type.rfind("list", 0) == 0 ? "0" : "7";
        check_refused("a.ply",
                      {{ply("element vertex 2\n" + head) + zero + " 1 2 3 4\n" + word + " 1 2 3 4\n", {message}}});
    };
    for (const std::string word : {"-129", "128", "1e9", "1.5", "7.0", "x", "99999999999999999999"})
        check("char", word, "an integer from -128 to 127");
    for (const std::string word : {"-1", "256", "1.5"}) check("uint8", word, "an integer from 0 to 255");
    check("short", "32768", "an integer from -32768 to 32767");
    check("ushort", "65536", "an integer from 0 to 65535");
    check("int", "2147483648", "an integer from -2147483648 to 2147483647");
    check("uint", "4294967296", "an integer from 0 to 4294967295");
    check("float", "abc", "a number from -3.4028234e38 to 3.4028234e38");
    check("double", "1e309", "a number from -1.7976931e308 to 1.7976931e308");
    check("list uchar int", "300", "an integer from 0 to 255");
    const std::string colors = "property uchar red\nproperty uchar green\nproperty uchar blue\n" + vertices;
    check_refused("a.ply", {{ply("element vertex 1\n" + colors) + "0 255 300 1 2 3 4\n",
                             {"vertex 0: found blue \"300\", expected an integer from 0 to 255"}}});
}
