#!/bin/sh
# Libraries of the browser build: SDL2 and zlib, built from Debian's source packages, and the
# libraries that are headers only, since /usr/include itself is wrong for another processor.
#   build_libraries.sh FOLDER
# FOLDER becomes a prefix with include, lib and share. Done once; takes some four minutes.
set -eu
export NODE_PATH=/usr/share/nodejs # Debian's em++ finds its own modules by this only

mkdir -p "$1"
folder=$(cd "$1" && pwd)
copy_headers() {
  mkdir -p "$folder/include" "$folder/share/cmake"
  # With their times, so that nothing is compiled anew.
  for library in nlohmann CLI stb utf8cpp; do cp -a "/usr/include/$library" "$folder/include"; done
  cp -a /usr/share/cmake/nlohmann_json /usr/share/cmake/CLI11 "$folder/share/cmake"
}

done_mark=$folder/done-6 # a new number whenever this script builds something else
[ ! -e "$done_mark" ] || {
  copy_headers
  exit 0
}
work=$folder/work
rm -rf "${folder:?}"/*
mkdir -p "$work/parts" "$work/lists/partial" "$work/cache/archives/partial" "$folder/lib"

copy_headers

# The machine's own sources of Debian, asked for source packages, in a folder of ours.
. /etc/os-release
for list in /etc/apt/sources.list /etc/apt/sources.list.d/*; do
  grep -Eqs "^[^#].*[[:space:]]$VERSION_CODENAME([[:space:]]|\$)" "$list" || continue
  case $list in
    *.list) sed -n "s/^deb\(.*[[:space:]]$VERSION_CODENAME\)/deb-src\1/p" "$list" \
      >"$work/parts/$(basename "$list")" ;;
    *.sources) sed 's/^Types:.*/Types: deb-src/' "$list" >"$work/parts/$(basename "$list")" ;;
  esac
done
apt() {
  apt-get -q -o Dir::Etc::sourcelist=/dev/null -o "Dir::Etc::sourceparts=$work/parts" \
    -o "Dir::State::lists=$work/lists" -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root "$@"
}
apt update
cd "$work"
# The versions that the native programs are linked with: the same text, the same packed bytes.
version() { dpkg-query -W -f='${source:Version}' "$1"; }
apt source "libsdl2=$(version libsdl2-dev)"
apt source "zlib=$(version zlib1g-dev)"

cd "$work"/libsdl2-*/
# The mixer gives what the page plays: where rates differ all the same, straight lines between
# samples will do, without SDL's filter of 20 KB.
cat >src/audio/SDL_audio_resampler_filter.h <<'END'
#define RESAMPLER_ZERO_CROSSINGS 1
#define RESAMPLER_SAMPLES_PER_ZERO_CROSSING 4
#define RESAMPLER_FILTER_SIZE 5
static const float ResamplerFilter[] = {1.0f, 0.75f, 0.5f, 0.25f, 0.0f};
static const float ResamplerFilterDifference[] = {-0.25f, -0.25f, -0.25f, -0.25f, 0.0f};
END
# Functions of OpenGL are linked with by name: to look them up all of them would have to be there.
# Nor does anything draw into the window's pixels.
sed -i 's/^#if SDL_VIDEO_DRIVER_UIKIT$/#if defined __EMSCRIPTEN__/' \
  src/render/opengles2/SDL_render_gles2.c
sed -i '/egl_data->eglGetProcAddress = /d' src/video/emscripten/SDL_emscriptenopengles.c
sed -i '/device->[A-Za-z]*WindowFramebuffer = /d; /device->GL_GetProcAddress = /d' \
  src/video/emscripten/SDL_emscriptenvideo.c
# Without drawing in software, which a page has no use for: half of SDL.
emcmake cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_INSTALL_PREFIX="$folder" \
  -DCMAKE_C_FLAGS=-DSDL_LEAN_AND_MEAN=1 "-DCMAKE_C_FLAGS_MINSIZEREL=-Os -DNDEBUG -flto" -DSDL_ASSERTIONS=disabled -DSDL_TEST=OFF -DSDL_SHARED=OFF \
  -DSDL_AUDIO=ON -DSDL_OPENGL=OFF -DSDL_JOYSTICK=OFF -DSDL_HAPTIC=OFF -DSDL_SENSOR=OFF -DSDL_HIDAPI=OFF \
  -DSDL_OFFSCREEN=OFF -DSDL_DUMMYVIDEO=OFF -DSDL_DISKAUDIO=OFF -DSDL_DUMMYAUDIO=OFF -DSDL_POWER=OFF
ninja -C build install
cd "$work"/zlib-*/
# Tables of 27 KB made at the start rather than loaded.
CHOST=emscripten CFLAGS="-Os -flto -DDYNAMIC_CRC_TABLE" emconfigure ./configure --static --prefix="$folder"
emmake make -j"$(nproc)" libz.a
cp zlib.h zconf.h "$folder/include"
cp libz.a "$folder/lib"
cd "$folder"
rm -rf "$work"
touch "$done_mark"
