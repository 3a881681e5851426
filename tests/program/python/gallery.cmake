# Each example of the gallery runs, and its page is the one of the manual. The target update-gallery
# writes the manual's pages and pictures anew. NOTE: pictures are not compared, as their bytes are
# those of a version of matplotlib and gnuplot.
# SPDX-License-Identifier: GPL-2.0-or-later
execute_process(COMMAND "${HVI_PYTHON}" -c "import matplotlib" RESULT_VARIABLE status
    OUTPUT_QUIET ERROR_QUIET)
if(NOT status EQUAL 0)
    message(STATUS "no matplotlib: the gallery is not tested")
    return()
endif()

set(gallery "${PROJECT_SOURCE_DIR}/examples/gallery")
set(pages "${PROJECT_SOURCE_DIR}/docs/gallery")
set(make "${HVI_PYTHON}" -B "${gallery}/make.py")
set(environment "HVI_GEN=${program}" "PYTHONPATH=${PROJECT_SOURCE_DIR}/python")
add_test(NAME gallery
    COMMAND ${make} "${CMAKE_CURRENT_BINARY_DIR}/gallery" --compare "${pages}")
set_tests_properties(gallery PROPERTIES LABELS python COST 2
    REQUIRED_FILES "${gallery};${pages};${program};${PROJECT_SOURCE_DIR}/python/hvi;${PROJECT_SOURCE_DIR}/examples/section6"
    ENVIRONMENT "${environment}")
add_custom_target(update-gallery
    COMMAND "${CMAKE_COMMAND}" -E env ${environment} ${make} "${pages}"
    DEPENDS hvi-gen VERBATIM)
