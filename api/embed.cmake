# Writes OUTPUT, a C++ source that defines `std::string_view NAMESPACE::FUNCTION()`, the text of FILE. HEADER declares it.
# Run as: cmake -DFILE=a.json -DOUTPUT=a.cpp -DHEADER=api/a.h -DNAMESPACE=bouguer::api -DFUNCTION=a_json -P embed.cmake
file(READ "${FILE}" hex HEX)
# Numbers and not a literal: a literal has an end to its length, and brackets and semicolons are lists to CMake.
string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${hex}")
string(REGEX REPLACE "(('[^']*',){16})" "\\1\n    " bytes "${bytes}")
get_filename_component(name "${FILE}" NAME)
file(WRITE "${OUTPUT}" "// Generated from ${name}.
#include \"${HEADER}\"

namespace ${NAMESPACE} {
namespace {
constexpr char kText[] = {
    ${bytes}};
}  // namespace
std::string_view ${FUNCTION}() { return {kText, sizeof kText}; }
}  // namespace ${NAMESPACE}
")
