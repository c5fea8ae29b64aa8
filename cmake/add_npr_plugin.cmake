# add_npr_plugin(STYLE [SOURCES file...] [FOLDER dir])
#   Builds the plugin STYLE from STYLE.cpp, or from SOURCES, as the loadable library STYLE.so with one exported function.
#   Its shaders stay where they are: the build folder only links to them, so that saving a shader shows at once.
#   This file serves the project's own styles and, installed with the package, everybody else's.
#   In the project's own build the same sources also enter the static table hatchway_static_plugins.
#   Elsewhere the result is a plugin folder, FOLDER or <build>/plugins, for `hatchway --plugin-dir FOLDER`.
include_guard(GLOBAL)

function(add_npr_plugin style)
    cmake_parse_arguments(PLUGIN "" "FOLDER" "SOURCES" ${ARGN})
    if(NOT style MATCHES "^[a-z0-9_]+$")
        message(FATAL_ERROR "add_npr_plugin: the style's name is \"${style}\"; expected [a-z0-9_]+")
    endif()
    if(NOT PLUGIN_SOURCES)
        set(PLUGIN_SOURCES ${style}.cpp)
    endif()
    if(HATCHWAY_IS_OWN_BUILD)
        set(library_folder "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/hatchway/plugins")
        set(shader_folder "${CMAKE_BINARY_DIR}/share/hatchway/plugins/${style}")
    else()
        set(library_folder "${CMAKE_BINARY_DIR}/plugins")
        if(PLUGIN_FOLDER)
            set(library_folder "${PLUGIN_FOLDER}")
        endif()
        set(shader_folder "${library_folder}/${style}")
    endif()

    add_library(plugin_${style} MODULE ${PLUGIN_SOURCES})
    set_target_properties(plugin_${style} PROPERTIES PREFIX "" OUTPUT_NAME ${style}
        LIBRARY_OUTPUT_DIRECTORY "${library_folder}" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_features(plugin_${style} PRIVATE cxx_std_20)
    get_filename_component(shader_parent "${shader_folder}" DIRECTORY)
    file(MAKE_DIRECTORY "${shader_parent}")
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${shader_folder}" SYMBOLIC)

    if(HATCHWAY_IS_OWN_BUILD)
        set_target_properties(plugin_${style} PROPERTIES INSTALL_RPATH "$ORIGIN/../..")
        target_link_libraries(plugin_${style} PRIVATE hatchway_flags hatchway)
        hatchway_own_plugin(${style} ${PLUGIN_SOURCES})
    else()
        target_link_libraries(plugin_${style} PRIVATE hatchway::hatchway)
    endif()
endfunction()
