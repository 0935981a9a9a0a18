#include "render/gui_painter.hpp"

#include <cstddef>
#include <cstdint>

#include <imgui.h>

namespace eisph {

namespace {

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void set_filter(const GlFunctions& gl, GLint filter) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

GuiPainter::GuiPainter(const GlFunctions& gl, const std::filesystem::path& shaders)
    : gl_(gl), program_(gl, shaders, "gui"), vertex_array_(gl), vertices_(gl), indices_(gl), fonts_(gl) {
  gl.BindVertexArray(vertex_array_.name());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  for (const GLuint attribute : {0U, 1U, 2U}) gl.EnableVertexAttribArray(attribute);
  constexpr GLsizei kStride = sizeof(ImDrawVert);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, offset(offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, offset(offsetof(ImDrawVert, col)));
}

void GuiPainter::set_fonts(ImFontAtlas& fonts) {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
  gl_.BindTexture(GL_TEXTURE_2D, fonts_.name());
  set_filter(gl_, GL_LINEAR);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  fonts.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(fonts_.name())));
}

void GuiPainter::draw(const ImDrawData& lists) const {
  const ImVec2 scale = lists.FramebufferScale;
  const auto width = static_cast<GLsizei>(lists.DisplaySize.x * scale.x);
  const auto height = static_cast<GLsizei>(lists.DisplaySize.y * scale.y);
  if (width <= 0 || height <= 0) return;
  gl_.Viewport(0, 0, width, height);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Enable(GL_SCISSOR_TEST);
  program_.use();
  program_.set("size", lists.DisplaySize.x, lists.DisplaySize.y);
  program_.set("origin", lists.DisplayPos.x, lists.DisplayPos.y);
  program_.set("image", 0);
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindVertexArray(vertex_array_.name());
  for (int n = 0; n < lists.CmdListsCount; ++n) {
    const ImDrawList& list = *lists.CmdLists[n];
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl_.BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data,
                   GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr) {
        if (command.UserCallback != ImDrawCallback_ResetRenderState) command.UserCallback(&list, &command);
        continue;
      }
      const auto left = static_cast<GLint>((command.ClipRect.x - lists.DisplayPos.x) * scale.x);
      const auto right = static_cast<GLint>((command.ClipRect.z - lists.DisplayPos.x) * scale.x);
      const auto top = static_cast<GLint>((command.ClipRect.y - lists.DisplayPos.y) * scale.y);
      const auto bottom = static_cast<GLint>((command.ClipRect.w - lists.DisplayPos.y) * scale.y);
      if (right <= left || bottom <= top) continue;
      gl_.Scissor(left, height - bottom, right - left, bottom - top);
      gl_.BindTexture(GL_TEXTURE_2D,
                      static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(command.GetTexID())));
      gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                 sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                 offset(command.IdxOffset * sizeof(ImDrawIdx)),
                                 static_cast<GLint>(command.VtxOffset));
    }
  }
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_BLEND);
}

void ImageTexture::set(const Image& image) {
  gl_.BindTexture(GL_TEXTURE_2D, texture_.name());
  set_filter(gl_, GL_LINEAR);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 image.rgb.data());
}

}  // namespace eisph
