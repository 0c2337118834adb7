# Headers of libraries, compiled once for all targets. GCC only: it takes X.gch for X wherever the search for includes
# finds it. Clang, and so clang-tidy, reads this build's commands and finds the same header as text, which it would not
# if the command named the precompiled file's path, as target_precompile_headers alone has it.
option(RAYSTEPS_PRECOMPILE "Compile headers of libraries once for all files (GCC); OFF shows includes that are missing" ON)

# Which of the precompiled headers a target takes: `libraries`, `test_libraries`, or none where it is empty.
define_property(TARGET PROPERTY RAYSTEPS_PRECOMPILED INITIALIZE_FROM_VARIABLE RAYSTEPS_PRECOMPILED)
if(RAYSTEPS_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    set(RAYSTEPS_PRECOMPILED libraries)
endif()

# Compiles cmake/NAME.h with the flags of the project and the libraries given. The commands of targets whose property says
# NAME search the folder of CMake's own header (cmake_pch.hxx) for it; they must depend on the target NAME.
function(precompile name)
    if(RAYSTEPS_PRECOMPILED)
        add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
        target_link_libraries(${name} PRIVATE compile_flags ${ARGN})
        target_precompile_headers(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/${name}.h)
        set(folder ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir)
        set(takes $<STREQUAL:$<TARGET_PROPERTY:RAYSTEPS_PRECOMPILED>,${name}>)
        target_compile_options(project_flags INTERFACE "$<${takes}:SHELL:-I${folder} -include cmake_pch.hxx>")
    endif()
endfunction()
