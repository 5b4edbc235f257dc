#pragma once

#include <GL/glcorearb.h>

#include <functional>

/// Every OpenGL function fumon calls: X(name without "gl", type).
#define FUMON_GL_FUNCTIONS(X)                                    \
    X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
    X(AttachShader, PFNGLATTACHSHADERPROC)                       \
    X(BindAttribLocation, PFNGLBINDATTRIBLOCATIONPROC)           \
    X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
    X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                 \
    X(BindTexture, PFNGLBINDTEXTUREPROC)                         \
    X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
    X(BlendEquation, PFNGLBLENDEQUATIONPROC)                     \
    X(BlendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC)             \
    X(BufferData, PFNGLBUFFERDATAPROC)                           \
    X(BufferSubData, PFNGLBUFFERSUBDATAPROC)                     \
    X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)   \
    X(Clear, PFNGLCLEARPROC)                                     \
    X(ClearBufferuiv, PFNGLCLEARBUFFERUIVPROC)                   \
    X(ClearColor, PFNGLCLEARCOLORPROC)                           \
    X(CullFace, PFNGLCULLFACEPROC)                               \
    X(ColorMask, PFNGLCOLORMASKPROC)                             \
    X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
    X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
    X(CreateShader, PFNGLCREATESHADERPROC)                       \
    X(DeleteBuffers, PFNGLDELETEBUFFERSPROC)                     \
    X(DeleteFramebuffers, PFNGLDELETEFRAMEBUFFERSPROC)           \
    X(DeleteProgram, PFNGLDELETEPROGRAMPROC)                     \
    X(DeleteShader, PFNGLDELETESHADERPROC)                       \
    X(DeleteTextures, PFNGLDELETETEXTURESPROC)                   \
    X(DeleteVertexArrays, PFNGLDELETEVERTEXARRAYSPROC)           \
    X(DepthFunc, PFNGLDEPTHFUNCPROC)                             \
    X(DepthMask, PFNGLDEPTHMASKPROC)                             \
    X(DepthRange, PFNGLDEPTHRANGEPROC)                           \
    X(Disable, PFNGLDISABLEPROC)                                 \
    X(DrawArrays, PFNGLDRAWARRAYSPROC)                           \
    X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)         \
    X(DrawElements, PFNGLDRAWELEMENTSPROC)                       \
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
    X(GetStringi, PFNGLGETSTRINGIPROC)                           \
    X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
    X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
    X(MapBufferRange, PFNGLMAPBUFFERRANGEPROC)                   \
    X(PixelStorei, PFNGLPIXELSTOREIPROC)                         \
    X(ReadPixels, PFNGLREADPIXELSPROC)                           \
    X(Scissor, PFNGLSCISSORPROC)                                 \
    X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
    X(StencilFunc, PFNGLSTENCILFUNCPROC)                         \
    X(StencilOp, PFNGLSTENCILOPPROC)                             \
    X(StencilMask, PFNGLSTENCILMASKPROC)                         \
    X(TexBuffer, PFNGLTEXBUFFERPROC)                             \
    X(TexImage2D, PFNGLTEXIMAGE2DPROC)                           \
    X(TexParameteri, PFNGLTEXPARAMETERIPROC)                     \
    X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                     \
    X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
    X(Uniform1i, PFNGLUNIFORM1IPROC)                             \
    X(Uniform2f, PFNGLUNIFORM2FPROC)                             \
    X(Uniform3f, PFNGLUNIFORM3FPROC)                             \
    X(Uniform4f, PFNGLUNIFORM4FPROC)                             \
    X(UniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC)               \
    X(UnmapBuffer, PFNGLUNMAPBUFFERPROC)                         \
    X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
    X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)         \
    X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
    X(Viewport, PFNGLVIEWPORTPROC)

namespace fumon::gl {

/// The entry points of one context. Two backends in one program have different ones, so there is
/// one table for each context.
struct Functions {
#define FUMON_GL_MEMBER(name, type) type name = nullptr;
    FUMON_GL_FUNCTIONS(FUMON_GL_MEMBER)
#undef FUMON_GL_MEMBER
};

/// Fills the table by `resolve("glName")`. Throws Error naming the first entry point missing.
Functions resolve_functions(const std::function<void*(const char*)>& resolve);

/// The entry points of the context current on this thread. Throws Error when there is none.
const Functions& functions();

/// Makes `table` (or none) the one of this thread. Called by contexts as they become current.
void set_functions(const Functions* table);

/// Throws Error naming `where` and the error when OpenGL has reported one since the last call.
void check_errors(const char* where);

/// From now on nothing is given back to any driver: an exception that says that memory has ended
/// may have come through one, whose locks it left behind, and the next call would wait for them for
/// ever. May be called wherever memory ends.
void abandon_drivers() noexcept;

/// Whether abandon_drivers() has been called.
bool drivers_are_abandoned() noexcept;

}  // namespace fumon::gl
