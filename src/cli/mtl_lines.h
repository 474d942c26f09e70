// The lines of an MTL file: checked, for its parser lets all pass, and where things stand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace selvage::cli {

struct MtlMaterial {
  std::string name;
  int line;              // of its newmtl
  int texture_line = 0;  // of its map_Kd; 0 without
};

struct MtlLines {
  std::string statements;  // newmtl (names as one word), Kd, illum and map_Kd, for the parser
  std::vector<MtlMaterial> materials;
};

// Numbers that are none, materials that stand twice and options of textures that are not heeded are
// UserErrors "FILE:LINE: KEYWORD: what is wrong", and so is what begins no statement of such a
// file. Other statements than these four are left out.
[[nodiscard]] MtlLines check_mtl_lines(const std::string& file, std::string_view text);

}  // namespace selvage::cli
