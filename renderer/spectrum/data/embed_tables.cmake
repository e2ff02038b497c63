# Writes OUTPUT, a C++ source that holds the text of FILES as string literals: what embedded_tables() gives.
# Run as: cmake -DFILES=a.csv;b.csv -DOUTPUT=tables.cpp -P embed_tables.cmake
set(entries "")
foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME_WE)
    file(READ "${file}" text)
    string(APPEND entries "    {\"${name}\", R\"csv(${text})csv\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from renderer/spectrum/data.
#include \"renderer/spectrum/data_table.h\"

namespace bouguer::renderer {
namespace {
constexpr EmbeddedTable kTables[] = {
${entries}};
}  // namespace
std::span<const EmbeddedTable> embedded_tables() { return kTables; }
}  // namespace bouguer::renderer
")
