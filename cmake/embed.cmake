# SPDX-License-Identifier: GPL-3.0-or-later
# Writes the text of FILES into OUT as `std::span<const EmbeddedFile> SYMBOL` (see lab/base/embedded.hpp).
set(body "")
set(part NAME_WE)
if(WITH_ENDINGS)
  set(part NAME)
endif()
string(REPLACE " " ";" files "${FILES}")
foreach(file IN LISTS files)
  file(READ "${file}" text)
  get_filename_component(name "${file}" ${part})
  string(APPEND body "    {\"${name}\", R\"__triax__(${text})__triax__\"sv},\n")
endforeach()
file(WRITE "${OUT}" "#include \"lab/base/embedded.hpp\"
namespace triax::lab {
using namespace std::string_view_literals;
namespace { constexpr EmbeddedFile kFiles[] = {
${body}}; }
extern const std::span<const EmbeddedFile> ${SYMBOL};
const std::span<const EmbeddedFile> ${SYMBOL}{kFiles};
}  // namespace triax::lab
")
