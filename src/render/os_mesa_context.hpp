#pragma once

#include "render/gl_context.hpp"

#include <array>
#include <filesystem>
#include <memory>

namespace eisph {

/// Mesa's software renderer drawing into memory. The library is opened at run time, since it brings GL
/// symbols of its own that must not mix with those of a window system.
class OsMesaContext final : public GlContext {
 public:
  /// Throws InputError when the library cannot be opened or is another one, std::runtime_error when it makes
  /// no context.
  explicit OsMesaContext(const std::filesystem::path& library = "libOSMesa.so.8");
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;
  ~OsMesaContext() override;

  void make_current() override;
  [[nodiscard]] const GlFunctions& functions() const override { return functions_; }
  [[nodiscard]] ContextKind kind() const override { return ContextKind::OsMesa; }

 private:
  struct Library;
  static constexpr int kWindowSize = 16;  ///< of the buffer that a context must have; frames use their own

  std::unique_ptr<Library> library_;
  void* context_ = nullptr;
  std::array<unsigned char, 4 * kWindowSize * kWindowSize> window_{};
  GlFunctions functions_;
};

}  // namespace eisph
