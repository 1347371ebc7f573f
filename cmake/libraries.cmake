# The properties of a library that others link with, static or shared (BUILD_SHARED_LIBS).
function(carom_library target)
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    # Visible is what the public headers declare.
    CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON)
  if(NOT EMSCRIPTEN)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    # A function of ours is the one that is called, so it may be inlined.
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()
include(GNUInstallDirs)
