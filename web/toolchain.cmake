# Debian's Emscripten. NODE_PATH=/usr/share/nodejs must be in the environment: ./run sets it.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(ANGRY_BALLS_WEB_LIBRARIES ${root}/build/web-libraries CACHE PATH
  "What web/build_libraries.sh made")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ANGRY_BALLS_WEB_LIBRARIES)
list(PREPEND CMAKE_FIND_ROOT_PATH ${ANGRY_BALLS_WEB_LIBRARIES})
list(PREPEND CMAKE_PREFIX_PATH ${ANGRY_BALLS_WEB_LIBRARIES})

# A program loaded over a line is small; only the code that steps worlds is quick (src/carom/CMakeLists.txt).
# The JSON library ends the program where it would throw, which nothing here would catch.
set(CMAKE_CXX_FLAGS_RELEASE "-Oz -flto -fno-rtti -DJSON_NOEXCEPTION -DNDEBUG" CACHE STRING "" FORCE)
set(CMAKE_CXX_FLAGS_INIT "-include ${CMAKE_CURRENT_LIST_DIR}/emscripten_library.hpp")
