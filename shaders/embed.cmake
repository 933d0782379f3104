# Writes every file of FILES (relative to ROOT) into OUT as voxprite::embeddedShaders(); see
# render/gl/shader_library.h, which declares it.
set(text "#include <map>\n#include <string>\n#include <string_view>\n\nnamespace voxprite {\n\n")
string(APPEND text "const std::map<std::string, std::string_view>& embeddedShaders();\n")
string(APPEND text "const std::map<std::string, std::string_view>& embeddedShaders() {\n")
string(APPEND text "    static const std::map<std::string, std::string_view> sources{\n")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} body)
  string(APPEND text "        {\"${file}\", R\"GLSL(${body})GLSL\"},\n")
endforeach()
string(APPEND text "    };\n    return sources;\n}\n\n}  // namespace voxprite\n")
file(WRITE ${OUT} "${text}")
