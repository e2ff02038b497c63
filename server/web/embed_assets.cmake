# Writes OUTPUT, a C++ source that holds FILES as string literals: what web_assets() gives. An element of FILES is
# "<request path>=<file>"; the media type follows from the file's extension.
# An empty <nav></nav> in a page becomes the links of NAVIGATION, so that they stand in one place.
# Run as: cmake "-DFILES=/=index.html;/app.js=app.js" -DNAVIGATION=nav.html -DOUTPUT=assets.cpp -P embed_assets.cmake
set(type_html "text/html; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_json "application/json")
set(type_svg "image/svg+xml")
set(type_png "image/png")
file(READ "${NAVIGATION}" navigation)
string(STRIP "${navigation}" navigation)
set(entries "")
foreach(element IN LISTS FILES)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${element}")
    set(path "${CMAKE_MATCH_1}")
    set(file "${CMAKE_MATCH_2}")
    get_filename_component(extension "${file}" LAST_EXT)
    string(SUBSTRING "${extension}" 1 -1 extension)
    if(extension STREQUAL "png")
        file(READ "${file}" bytes HEX)
        string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
        set(literal "\"${bytes}\"sv")
    else()
        file(READ "${file}" text)
        string(REPLACE "<nav></nav>" "${navigation}" text "${text}")
        set(literal "R\"asset(${text})asset\"sv")
    endif()
    string(APPEND entries "    {\"${path}\", \"${type_${extension}}\", ${literal}},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from server/web.
#include \"server/web/web_assets.h\"

namespace bouguer::server {
namespace {
using namespace std::string_view_literals;
constexpr WebAsset kAssets[] = {
${entries}};
}  // namespace
std::span<const WebAsset> web_assets() { return kAssets; }
}  // namespace bouguer::server
")
