# Turns the report page into a source of two raw string literals: cmake -DOUTPUT=x.cpp -DPAGE=report.html -P embed_report.cmake
set(delimiter "REPORT_PAGE")
set(mark "<!--run-->")
file(READ "${PAGE}" text)
string(FIND "${text}" ")${delimiter}\"" clash)
string(FIND "${text}" "${mark}" at)
if(NOT clash EQUAL -1 OR at EQUAL -1)
  message(FATAL_ERROR "${PAGE} lacks ${mark}, or holds )${delimiter}\", which ends its literal")
endif()
string(LENGTH "${mark}" length)
string(SUBSTRING "${text}" 0 ${at} head)
math(EXPR behind "${at} + ${length}")
string(SUBSTRING "${text}" ${behind} -1 tail)
file(WRITE "${OUTPUT}" "// Generated from scripts/report; do not edit.
#include \"io/output/report/report_page.h\"

namespace voussoir::io {

ReportPage report_page() noexcept {
  return {R\"${delimiter}(${head})${delimiter}\", R\"${delimiter}(${tail})${delimiter}\"};
}

}  // namespace voussoir::io
")
