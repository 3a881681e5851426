# hvi_generate(): has hvi-gen write a stepper while your project is built.
# SPDX-License-Identifier: MIT
#
#   hvi_generate(TARGET target HEADER file.hpp
#                METHOD name | BASIS text NODES text | METHOD_FILE file.toml
#                [SCENE name | SCENE file.toml | SEPARABLE] [NAME class] [OPTIONS option...])
#
# Makes the INTERFACE library `target`, or adds to it: what links it can #include "file.hpp", and
# "potential.hpp" beside the file of a scene, which functions of its own stand in and which is not
# called as HEADER. The methods and options are those of `hvi-gen stepper`; METHOD_FILE and the file
# of a scene are relative to the directory of the caller. OPTIONS takes any others, as in OPTIONS
# --param w=2.
#
#   hvi_generate_module(TARGET target SCENE name | SCENE file.toml [NAME name] [SHARED]
#                       [METHOD name | BASIS text NODES text | METHOD_FILE file.toml]
#                       [OPTIONS option...])
#
# Makes the library `target` of the C module NAME, static unless it is SHARED: C and C++ programs that
# link it can #include "NAME.h". The options are those of `hvi-gen module`; without a NAME it is TARGET.
#
# The program is hvi::hvi-gen, or the one that HVI_GEN_EXECUTABLE names: set it when you compile for
# another machine.

# The words of a method and of a scene, in `options`; the files among them, with full paths, in `inputs`;
# the program, in `hvi_gen`. NOTE: a macro: it reads the arguments of its caller.
macro(_hvi_generate_read function)
    cmake_parse_arguments(PARSE_ARGV 0 arg "SEPARABLE;SHARED"
        "TARGET;HEADER;METHOD;BASIS;NODES;METHOD_FILE;SCENE;NAME" "OPTIONS")
    if(arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "${function}: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
    endif()
    set(options)
    set(inputs)
    foreach(option METHOD BASIS NODES METHOD_FILE NAME)
        if(DEFINED arg_${option})
            string(TOLOWER "${option}" word)
            string(REPLACE "_" "-" word "${word}")
            list(APPEND options "--${word}=${arg_${option}}")
        endif()
    endforeach()
    if(arg_METHOD_FILE)
        file(REAL_PATH "${arg_METHOD_FILE}" method_file BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
        list(APPEND inputs "${method_file}")
    endif()
    if(arg_SCENE MATCHES "[.]toml$")
        file(REAL_PATH "${arg_SCENE}" scene BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
        list(APPEND inputs "${scene}")
    endif()
    if(HVI_GEN_EXECUTABLE)
        set(hvi_gen "${HVI_GEN_EXECUTABLE}")
    elseif(TARGET hvi::hvi-gen)
        set(hvi_gen hvi::hvi-gen)
    else()
        message(FATAL_ERROR "${function}: this hvi was built without hvi-gen; "
            "set HVI_GEN_EXECUTABLE, or build hvi with HVI_BUILD_GENERATOR=ON")
    endif()
endmacro()

function(hvi_generate)
    _hvi_generate_read(hvi_generate)
    if(NOT arg_TARGET OR NOT arg_HEADER)
        message(FATAL_ERROR "hvi_generate: TARGET and HEADER are needed")
    endif()
    if(arg_SHARED)
        message(FATAL_ERROR "hvi_generate: unknown arguments: SHARED")
    endif()
    if(arg_SEPARABLE)
        list(APPEND options --separable)
    endif()

    set(directory "${CMAKE_CURRENT_BINARY_DIR}/hvi_generate/${arg_TARGET}")
    set(header "${directory}/${arg_HEADER}")
    cmake_path(GET header PARENT_PATH parent)
    file(MAKE_DIRECTORY "${parent}")
    # NOTE: run where the caller stands, so that the header quotes METHOD_FILE as the caller wrote it.
    # A header that comes out as it was keeps its time, so that nothing is compiled again for it.
    add_custom_command(
        OUTPUT "${header}.written"
        BYPRODUCTS "${header}"
        COMMAND ${hvi_gen} stepper ${options} ${arg_OPTIONS} ${arg_SCENE} -o "${header}.written"
        COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${header}.written" "${header}"
        DEPENDS ${hvi_gen} ${inputs}
        WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
        COMMENT "Generating ${arg_HEADER}"
        VERBATIM)

    if(NOT TARGET ${arg_TARGET})
        add_library(${arg_TARGET} INTERFACE)
        target_link_libraries(${arg_TARGET} INTERFACE hvi::runtime)
    endif()
    target_sources(${arg_TARGET}
        INTERFACE FILE_SET HEADERS BASE_DIRS "${directory}" FILES "${header}")
    if(arg_SCENE MATCHES "[.]toml$")
        cmake_path(GET scene PARENT_PATH beside_scene)
        target_include_directories(${arg_TARGET} INTERFACE "$<BUILD_INTERFACE:${beside_scene}>")
    endif()
    # What links the target is compiled after the header is written, also in other directories.
    string(MAKE_C_IDENTIFIER "${arg_TARGET}_${arg_HEADER}" step)
    add_custom_target(${step} DEPENDS "${header}.written")
    add_dependencies(${arg_TARGET} ${step})
endfunction()

function(hvi_generate_module)
    _hvi_generate_read(hvi_generate_module)
    if(NOT arg_TARGET OR NOT arg_SCENE)
        message(FATAL_ERROR "hvi_generate_module: TARGET and SCENE are needed")
    endif()
    if(arg_HEADER OR arg_SEPARABLE)
        message(FATAL_ERROR "hvi_generate_module: HEADER and SEPARABLE are of hvi_generate")
    endif()
    set(name "${arg_NAME}")
    if(NOT name)
        set(name "${arg_TARGET}")
        list(APPEND options "--name=${name}")
    endif()

    set(directory "${CMAKE_CURRENT_BINARY_DIR}/hvi_generate/${arg_TARGET}")
    file(MAKE_DIRECTORY "${directory}")
    add_custom_command(
        OUTPUT "${directory}/${name}.cpp" "${directory}/${name}.h"
        COMMAND ${hvi_gen} module ${options} ${arg_OPTIONS} ${arg_SCENE} -o "${directory}"
        DEPENDS ${hvi_gen} ${inputs}
        WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
        COMMENT "Generating ${name}.cpp"
        VERBATIM)

    find_package(Threads REQUIRED)
    set(kind STATIC)
    if(arg_SHARED)
        set(kind SHARED)
    endif()
    add_library(${arg_TARGET} ${kind} "${directory}/${name}.cpp")
    target_link_libraries(${arg_TARGET} PRIVATE hvi::runtime Threads::Threads)
    target_include_directories(${arg_TARGET} INTERFACE "${directory}")
    if(arg_SCENE MATCHES "[.]toml$")
        cmake_path(GET scene PARENT_PATH beside_scene)
        target_include_directories(${arg_TARGET} PRIVATE "${beside_scene}")
    endif()
endfunction()
