# The target `formatting` is fmt. Render programs are linked statically where that is possible (RAYSTEPS_STATIC): loading six
# shared libraries took 1 ms of the 5 that a small picture takes.
find_package(fmt REQUIRED)
option(RAYSTEPS_STATIC "Link render programs statically (GCC, without sanitizers)" ON)
if(RAYSTEPS_STATIC AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT RAYSTEPS_SANITIZE AND fmt_VERSION VERSION_LESS 10)
    add_library(formatting STATIC cmake/formatting.cpp)
    get_target_property(folders fmt::fmt INTERFACE_INCLUDE_DIRECTORIES)
    target_include_directories(formatting SYSTEM PUBLIC ${folders})
    target_link_libraries(formatting PRIVATE compile_flags)
    set(RAYSTEPS_RENDER_LINKED -static)
else()
    add_library(formatting INTERFACE)
    target_link_libraries(formatting INTERFACE fmt::fmt)
endif()
