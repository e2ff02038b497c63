# Writes OUTPUT, a C++ source that holds FILES as string literals: what web_assets() gives. An element of FILES is
# "<request path>=<file>"; the media type follows from the file's extension.
# Run as: cmake "-DFILES=/=index.html;/app.js=app.js" -DOUTPUT=assets.cpp -P embed_assets.cmake
set(type_html "text/html; charset=utf-8")
set(type_css "text/css; charset=utf-8")
set(type_js "text/javascript; charset=utf-8")
set(type_json "application/json")
set(type_svg "image/svg+xml")
set(entries "")
foreach(element IN LISTS FILES)
    string(REGEX MATCH "^([^=]+)=(.+)$" _ "${element}")
    set(path "${CMAKE_MATCH_1}")
    set(file "${CMAKE_MATCH_2}")
    get_filename_component(extension "${file}" LAST_EXT)
    string(SUBSTRING "${extension}" 1 -1 extension)
    file(READ "${file}" text)
    string(APPEND entries "    {\"${path}\", \"${type_${extension}}\", R\"asset(${text})asset\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from server/web.
#include \"server/web/web_assets.h\"

namespace bouguer::server {
namespace {
constexpr WebAsset kAssets[] = {
${entries}};
}  // namespace
std::span<const WebAsset> web_assets() { return kAssets; }
}  // namespace bouguer::server
")
