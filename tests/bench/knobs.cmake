# The solutions' constants as knobs: copies of a solution's file with another number in it, each linked to a program of
# its own. So the solution stays as it is, and a chart shows what other numbers would have cost.
#
# Programs are named PROGRAM-KNOB-VALUE. What was made stands in bin/knobs.txt, a line each: "step knob value program".

set(KNOB_LIST ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/knobs.txt)
file(WRITE ${KNOB_LIST}.new "")

# Writes a copy of solutions/${file} in which what matches `pattern` (once) is replaced, and sets `result` to its path;
# to nothing, with a warning, when the solution has no such text any more.
function(vary_solution result file name pattern replacement)
    set(${result} "" PARENT_SCOPE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/solutions/${file})
    # Code is no list: without this its semicolons and brackets would be taken for one.
    file(READ ${CMAKE_SOURCE_DIR}/solutions/${file} text)
    string(REGEX MATCHALL "${pattern}" found "${text}")
    list(LENGTH found times)
    if(NOT times EQUAL 1)
        message(WARNING "solutions/${file} has ${times} places like '${pattern}', not one: no chart of ${name}")
        return()
    endif()
    string(REGEX REPLACE "${pattern}" "${replacement}" text "${text}")
    set(copy ${CMAKE_CURRENT_BINARY_DIR}/knobs/${name}.cpp)
    file(WRITE ${copy}.new "${text}")
    file(COPY_FILE ${copy}.new ${copy} ONLY_IF_DIFFERENT)
    set(${result} ${copy} PARENT_SCOPE)
endfunction()

# A program like `program` (made of `sources` and `libraries`), with `copy` in place of step `step`'s file.
function(add_varied_program target step file copy sources libraries)
    get_filename_component(name ${file} NAME)
    add_executable(${target} EXCLUDE_FROM_ALL ${sources} ${copy}
        $<FILTER:$<TARGET_OBJECTS:solution_${step}>,EXCLUDE,/${name}.o$>)
    target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR}/solutions)  # as the solutions' own
    target_link_libraries(${target} PRIVATE ${libraries})
endfunction()

# One program for each value of the number `constant` in step 4's `file`.
function(add_knob file knob constant)
    foreach(value IN LISTS ARGN)
        set(program measure-4-${knob}-${value})
        vary_solution(copy 4_partitioning/${file} ${knob}-${value} "(${constant} = )[0-9.]+" "\\1${value}")
        if(copy)
            add_varied_program(${program} 4 ${file} ${copy} measure/main_4.cpp "step_4_subjects;solution_1")
            add_dependencies(measure-knobs ${program})
            file(APPEND ${KNOB_LIST}.new "4 ${knob} ${value} ${program}\n")
        endif()
    endforeach()
endfunction()

add_custom_target(measure-knobs)

# Fresnel by Schlick's formula, in whole pictures.
vary_solution(copy 3_recursion/recursion.cpp fresnel-schlick "r[.]fresnel [?] fresnel\\(" "r.fresnel ? schlick(")
if(copy)
    add_varied_program(render-schlick 3 recursion.cpp ${copy} "$<TARGET_OBJECTS:render_main>"
        "renderer;solution_1;solution_2;solution_4;solution_5")
    # Built with all the rest: it needs every step, so a new one shows here, not when somebody wants a chart.
    set_target_properties(render-schlick PROPERTIES EXCLUDE_FROM_ALL OFF)
    add_dependencies(measure-knobs render-schlick)
    file(APPEND ${KNOB_LIST}.new "3 fresnel schlick render-schlick\n")
endif()
add_knob(grid.cpp grid-density kDensity 0.25 0.5 1 2 4 8 16)
add_knob(octree.cpp octree-leaf kMostInLeaf 2 4 8 16 32 64)
add_knob(octree.cpp octree-depth kMostDeep 2 3 4 5 20)
add_knob(bvh.cpp bvh-leaf kMostInLeaf 1 2 4 8)
file(COPY_FILE ${KNOB_LIST}.new ${KNOB_LIST} ONLY_IF_DIFFERENT)
