#pragma once

#include "render/gl_object.hpp"
#include "render/image.hpp"
#include "render/shader_program.hpp"

#include <filesystem>

struct ImDrawData;
struct ImFontAtlas;

namespace eisph {

/// Draws the lists of Dear ImGui in whatever context, where the backend that comes with ImGui needs a window
/// system. Texture numbers of the lists are names of GL textures.
class GuiPainter {
 public:
  GuiPainter(const GlFunctions& gl, const std::filesystem::path& shaders);

  /// Takes the letters over; again after fonts have changed.
  void set_fonts(ImFontAtlas& fonts);
  /// Draws into the framebuffer that is bound, over what is there.
  void draw(const ImDrawData& lists) const;

 private:
  const GlFunctions& gl_;
  ShaderProgram program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  GlTexture fonts_;
};

/// A picture from the processor as a texture.
class ImageTexture {
 public:
  explicit ImageTexture(const GlFunctions& gl) : gl_(gl), texture_(gl) {}
  void set(const Image& image);
  [[nodiscard]] GLuint name() const { return texture_.name(); }

 private:
  const GlFunctions& gl_;
  GlTexture texture_;
};

}  // namespace eisph
