# Finds Qwt 6.3 built for Qt 6: the target Qwt::Qwt, and Qwt_VERSION. Set Qwt_ROOT to look in a folder first.
# Qwt's own pkg-config file asks for Qt 5, so the library is looked for by name; one that is linked to Qt 5 is refused.
find_path(Qwt_INCLUDE_DIR qwt_global.h PATH_SUFFIXES qwt-qt6 qwt6-qt6 qt6/qwt qwt)
find_library(Qwt_LIBRARY NAMES qwt-qt6 qwt6-qt6 qwt)

if(Qwt_INCLUDE_DIR)
  file(STRINGS ${Qwt_INCLUDE_DIR}/qwt_global.h _qwt_line REGEX "QWT_VERSION_STR")
  string(REGEX REPLACE ".*\"([0-9.]+)\".*" "\\1" Qwt_VERSION "${_qwt_line}")
endif()

set(_qwt_reason "")
if(Qwt_LIBRARY MATCHES "\\.so")
  find_program(_qwt_readelf readelf)
  if(_qwt_readelf)
    execute_process(COMMAND ${_qwt_readelf} -d ${Qwt_LIBRARY} OUTPUT_VARIABLE _qwt_needed ERROR_QUIET)
    if(_qwt_needed MATCHES "libQt5")
      set(_qwt_reason "${Qwt_LIBRARY} is built for Qt 5; Carom needs Qwt for Qt 6 (app/setup builds it)")
      set(Qwt_LIBRARY Qwt_LIBRARY-NOTFOUND)
    endif()
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qwt
  REQUIRED_VARS Qwt_LIBRARY Qwt_INCLUDE_DIR
  VERSION_VAR Qwt_VERSION
  REASON_FAILURE_MESSAGE "${_qwt_reason}")

if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
  add_library(Qwt::Qwt UNKNOWN IMPORTED)
  set_target_properties(Qwt::Qwt PROPERTIES
    IMPORTED_LOCATION ${Qwt_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Qwt_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::PrintSupport;Qt6::Svg;Qt6::OpenGL;Qt6::OpenGLWidgets")
endif()
mark_as_advanced(Qwt_INCLUDE_DIR Qwt_LIBRARY)
