# Turns case files into one source of raw string literals: cmake -DOUTPUT=x.cpp -DFOLDER=dir -DNAMES=a,b -P embed_catalogue.cmake
string(REPLACE "," ";" names "${NAMES}")
set(delimiter "CASE_FILE")
set(entries "")
foreach(name IN LISTS names)
  file(READ "${FOLDER}/${name}.toml" text)
  string(FIND "${text}" ")${delimiter}\"" clash)
  if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${name}.toml holds )${delimiter}\", which ends its literal")
  endif()
  string(APPEND entries "      {\"${name}\", R\"${delimiter}(${text})${delimiter}\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Generated from cases/catalogue; do not edit.
#include \"io/input/case_file/built_in_cases.h\"

namespace voussoir::io {

std::vector<BuiltInCase> built_in_cases() {
  return {
${entries}  };
}

}  // namespace voussoir::io
")
