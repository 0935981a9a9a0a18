#pragma once

#include <functional>

#include <GL/glcorearb.h>

namespace eisph {

// The OpenGL 3.3 functions in use: name without "gl", and type.
#define EISPH_GL_FUNCTIONS(X)                                  \
  X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
  X(AttachShader, PFNGLATTACHSHADERPROC)                       \
  X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
  X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                 \
  X(BindTexture, PFNGLBINDTEXTUREPROC)                         \
  X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
  X(BlendFunc, PFNGLBLENDFUNCPROC)                             \
  X(BufferData, PFNGLBUFFERDATAPROC)                           \
  X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)   \
  X(Clear, PFNGLCLEARPROC)                                     \
  X(ClearColor, PFNGLCLEARCOLORPROC)                           \
  X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
  X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
  X(CreateShader, PFNGLCREATESHADERPROC)                       \
  X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                     \
  X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)           \
  X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                     \
  X(DeleteShader, PFNGLDELETESHADERPROC)                       \
  X(DeleteTextures, PFNGLDELETETEXTURESPROC)                   \
  X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)           \
  X(DepthMask, PFNGLDEPTHMASKPROC)                             \
  X(DepthFunc, PFNGLDEPTHFUNCPROC)                             \
  X(Disable, PFNGLDISABLEPROC)                                 \
  X(DrawArrays, PFNGLDRAWARRAYSPROC)                           \
  X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)         \
  X(DrawElementsBaseVertex, PFNGLDRAWELEMENTSBASEVERTEXPROC)   \
  X(Enable, PFNGLENABLEPROC)                                   \
  X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC) \
  X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)       \
  X(GenBuffers, PFNGLGENBUFFERSPROC)                           \
  X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                 \
  X(GenTextures, PFNGLGENTEXTURESPROC)                         \
  X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                 \
  X(GetError, PFNGLGETERRORPROC)                               \
  X(GetIntegerv, PFNGLGETINTEGERVPROC)                         \
  X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)             \
  X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                       \
  X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)               \
  X(GetShaderiv, PFNGLGETSHADERIVPROC)                         \
  X(GetString, PFNGLGETSTRINGPROC)                             \
  X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
  X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
  X(PixelStorei, PFNGLPIXELSTOREIPROC)                         \
  X(ReadPixels, PFNGLREADPIXELSPROC)                           \
  X(Scissor, PFNGLSCISSORPROC)                                 \
  X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
  X(TexImage2D, PFNGLTEXIMAGE2DPROC)                           \
  X(TexParameteri, PFNGLTEXPARAMETERIPROC)                     \
  X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
  X(Uniform1i, PFNGLUNIFORM1IPROC)                             \
  X(Uniform2f, PFNGLUNIFORM2FPROC)                             \
  X(Uniform3f, PFNGLUNIFORM3FPROC)                             \
  X(UniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC)               \
  X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
  X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)         \
  X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
  X(Viewport, PFNGLVIEWPORTPROC)

/// Functions of one context; nothing is linked against a GL library.
struct GlFunctions {
#define EISPH_GL_DECLARE(name, type) type name = nullptr;
  EISPH_GL_FUNCTIONS(EISPH_GL_DECLARE)
#undef EISPH_GL_DECLARE
};

/// `address_of` gives the address of a function by its full name. Throws std::runtime_error for a missing
/// one.
[[nodiscard]] GlFunctions load_gl_functions(const std::function<void*(const char*)>& address_of);

/// Throws std::runtime_error with the code when an error is pending; `where` says after what.
void check_gl(const GlFunctions& gl, const char* where);

}  // namespace eisph
