# Turns a file into a C++ source that defines app::SYMBOL, a span over its bytes:
#   cmake -DINPUT=font.ttf -DOUTPUT=font.cpp -DSYMBOL=lato_bold -P embed.cmake
file(READ "${INPUT}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"app/font_data.hpp\"\n
namespace {
constexpr unsigned char bytes[] = {
${bytes}
};
}\n
constinit const std::span<const unsigned char> app::${SYMBOL}{bytes};
")
