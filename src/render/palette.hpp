#pragma once

#include "render/colour.hpp"

namespace eisph {

/// Colours of everything on a frame that does not come from a colour map.
struct Palette {
  Colour page;
  Colour text;
  Colour line;       ///< outlines, axes, walls
  Colour faint;      ///< open edges, grid lines of axes
  Colour floor;      ///< floor of a three-dimensional view
  Colour grid;       ///< lines on the floor
  Colour dry_floor;  ///< depth map without water: light on any page, as deeper means darker
  Colour solid;      ///< obstacles and dams
  Colour gate;
  Colour glass;        ///< what panes of glass mirror
  Colour fluid_kind;   ///< field "kind"
  Colour object_kind;  ///< field "kind"
  Colour ghost_kind;
  Colour virtual_kind;
};

[[nodiscard]] inline Palette palette(bool dark_background) {
  Palette colours{.page = {0.985F, 0.985F, 0.98F},
                  .text = {0.10F, 0.10F, 0.11F},
                  .line = {0.25F, 0.26F, 0.28F},
                  .faint = {0.62F, 0.63F, 0.65F},
                  .floor = {0.87F, 0.87F, 0.85F},
                  .grid = {0.78F, 0.78F, 0.76F},
                  .dry_floor = {0.96F, 0.96F, 0.95F},
                  .solid = {0.70F, 0.66F, 0.60F},
                  .gate = {0.82F, 0.52F, 0.30F},
                  .glass = {0.66F, 0.78F, 0.82F},
                  .fluid_kind = {0.22F, 0.47F, 0.76F},
                  .object_kind = {0.86F, 0.55F, 0.20F},
                  .ghost_kind = {0.62F, 0.66F, 0.72F},
                  .virtual_kind = {0.55F, 0.30F, 0.52F}};
  if (dark_background) {
    colours.page = {0.09F, 0.10F, 0.12F};
    colours.text = {0.93F, 0.93F, 0.94F};
    colours.line = {0.72F, 0.73F, 0.75F};
    colours.faint = {0.42F, 0.43F, 0.46F};
    colours.floor = {0.23F, 0.24F, 0.26F};
    colours.grid = {0.32F, 0.33F, 0.35F};
    colours.glass = {0.60F, 0.72F, 0.78F};
  }
  return colours;
}

}  // namespace eisph
