# Writes the licence texts that go with the programs, under a heading each:
#   cmake -DROOT=… -DOUTPUT=licences.txt [-DSOURCE=licences.cpp] -P collect.cmake
# SOURCE: the same text as a C++ source (licences.hpp).
set(parts
  "Angry Balls|${ROOT}/LICENSE"
  "CLI11: the command line|/usr/share/doc/libcli11-dev/copyright"
  "JSON for Modern C++: files|/usr/share/doc/nlohmann-json3-dev/copyright"
  "UTF8-CPP: texts|/usr/share/doc/libutfcpp-dev/copyright"
  "stb: fonts and pictures|/usr/share/doc/libstb-dev/copyright"
  "Lato: the typeface|/usr/share/doc/fonts-lato/copyright"
  "zlib: links|/usr/share/doc/zlib1g-dev/copyright"
  "SDL: windows, input and sound|/usr/share/doc/libsdl2-dev/copyright")

file(WRITE ${OUTPUT} "")
foreach(part IN LISTS parts)
  string(REPLACE "|" ";" part "${part}")
  list(GET part 0 title)
  list(GET part 1 file)
  if(EXISTS ${file})
    file(READ ${file} licence)
  else()
    message(WARNING "The licence of ${title} is not in ${file}")
    set(licence "Its text was not found where this program was built.\n")
  endif()
  string(REGEX REPLACE "." "=" line "${title}")
  file(APPEND ${OUTPUT} "${title}\n${line}\n\n${licence}\n\n")
endforeach()

if(SOURCE)
  file(READ ${OUTPUT} bytes HEX)
  string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
  file(WRITE ${SOURCE} "#include \"licences/licences.hpp\"\n
namespace {
constexpr char bytes[] = {\n${bytes}\n};
}\n
constinit const std::string_view licences::text{bytes, sizeof bytes};
")
endif()
