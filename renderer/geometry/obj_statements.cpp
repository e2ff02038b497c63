// SPDX-License-Identifier: Apache-2.0
#include "renderer/geometry/obj_statements.h"

#include <algorithm>
#include <array>

namespace bouguer::renderer {
namespace {

/// Every statement of the format [Wavefront, Advanced Visualizer, appendix B1: Object Files].
constexpr std::array kKeywords{
    ObjKeyword{"v", ObjStatement::Vertex},
    ObjKeyword{"vt", ObjStatement::TextureVertex},
    ObjKeyword{"vn", ObjStatement::Normal},
    ObjKeyword{"f", ObjStatement::Face},
    ObjKeyword{"fo", ObjStatement::Face},  // as the format was before version 2.11
    ObjKeyword{"usemtl", ObjStatement::Material},
    ObjKeyword{"g", ObjStatement::Nothing},
    ObjKeyword{"o", ObjStatement::Nothing},
    ObjKeyword{"s", ObjStatement::Smoothing},
    ObjKeyword{"mg", ObjStatement::Nothing},
    ObjKeyword{"bevel", ObjStatement::Nothing},
    ObjKeyword{"c_interp", ObjStatement::Nothing},
    ObjKeyword{"d_interp", ObjStatement::Nothing},
    ObjKeyword{"lod", ObjStatement::Nothing},
    ObjKeyword{"mtllib", ObjStatement::Nothing},
    ObjKeyword{"usemap", ObjStatement::Map},
    ObjKeyword{"maplib", ObjStatement::Nothing},
    ObjKeyword{"ctech", ObjStatement::Nothing},
    ObjKeyword{"stech", ObjStatement::Nothing},
    ObjKeyword{"p", ObjStatement::Dropped, "points"},
    ObjKeyword{"l", ObjStatement::Dropped, "lines"},
    ObjKeyword{"shadow_obj", ObjStatement::Dropped, "a shape for shadows (shadow_obj)"},
    ObjKeyword{"trace_obj", ObjStatement::Dropped, "a shape for reflections (trace_obj)"},
    ObjKeyword{"call", ObjStatement::Dropped, "other files (call)"},
    ObjKeyword{"csh", ObjStatement::Dropped, "commands (csh)"},
    ObjKeyword{"vp", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"cstype", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"deg", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"bmat", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"step", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"curv", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"curv2", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"surf", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"parm", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"trim", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"hole", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"scrv", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"sp", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"end", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"con", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"bsp", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"bzp", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"cdc", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"cdp", ObjStatement::Dropped, "curves and surfaces"},
    ObjKeyword{"res", ObjStatement::Dropped, "curves and surfaces"},
};

}  // namespace

const ObjKeyword* find_obj_keyword(std::string_view word) {
    const auto it = std::find_if(kKeywords.begin(), kKeywords.end(),
                                 [&](const ObjKeyword& k) { return k.word == word; });
    return it == kKeywords.end() ? nullptr : it;
}

}  // namespace bouguer::renderer
