// The GL functions that the canvas calls, looked up at run time: no target links a GL library.
#pragma once

#include <GL/glcorearb.h>

#include "render/canvas/offscreen_context.hpp"

namespace tumble::render {

// One entry per function: its name without "gl", and the type of a pointer to it.
#define TUMBLE_GL_FUNCTIONS(X)                                   \
    X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
    X(AttachShader, PFNGLATTACHSHADERPROC)                       \
    X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
    X(BindTexture, PFNGLBINDTEXTUREPROC)                         \
    X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
    X(BlendFunc, PFNGLBLENDFUNCPROC)                             \
    X(BufferData, PFNGLBUFFERDATAPROC)                           \
    X(Clear, PFNGLCLEARPROC)                                     \
    X(ClearColor, PFNGLCLEARCOLORPROC)                           \
    X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
    X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
    X(CreateShader, PFNGLCREATESHADERPROC)                       \
    X(DeleteShader, PFNGLDELETESHADERPROC)                       \
    X(DeleteTextures, PFNGLDELETETEXTURESPROC)                   \
    X(Disable, PFNGLDISABLEPROC)                                 \
    X(DrawArrays, PFNGLDRAWARRAYSPROC)                           \
    X(DrawArraysInstanced, PFNGLDRAWARRAYSINSTANCEDPROC)         \
    X(Enable, PFNGLENABLEPROC)                                   \
    X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC) \
    X(Finish, PFNGLFINISHPROC)                                   \
    X(GenBuffers, PFNGLGENBUFFERSPROC)                           \
    X(GenTextures, PFNGLGENTEXTURESPROC)                         \
    X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                 \
    X(GenerateMipmap, PFNGLGENERATEMIPMAPPROC)                   \
    X(GetError, PFNGLGETERRORPROC)                               \
    X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)             \
    X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                       \
    X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)               \
    X(GetShaderiv, PFNGLGETSHADERIVPROC)                         \
    X(GetString, PFNGLGETSTRINGPROC)                             \
    X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
    X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
    X(PixelStorei, PFNGLPIXELSTOREIPROC)                         \
    X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
    X(TexImage2D, PFNGLTEXIMAGE2DPROC)                           \
    X(TexParameteri, PFNGLTEXPARAMETERIPROC)                     \
    X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
    X(Uniform2f, PFNGLUNIFORM2FPROC)                             \
    X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
    X(VertexAttribDivisor, PFNGLVERTEXATTRIBDIVISORPROC)         \
    X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
    X(Viewport, PFNGLVIEWPORTPROC)

struct GlApi {
#define TUMBLE_GL_MEMBER(name, type) type name = nullptr;
    TUMBLE_GL_FUNCTIONS(TUMBLE_GL_MEMBER)
#undef TUMBLE_GL_MEMBER
};

// Throws RenderError that names the first function that the context lacks.
GlApi load_gl_api(const OffscreenContext& context);

}  // namespace tumble::render
