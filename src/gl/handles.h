#pragma once

#include <utility>

#include "gl/functions.h"

namespace fumon::gl {

/// Owns one OpenGL name; `Kind` makes and deletes it. It must die before its context does.
template <class Kind>
class Handle {
  public:
    Handle() : name_(Kind::make()) {}
    ~Handle() {
        if (name_ != 0 && !drivers_are_abandoned()) Kind::destroy(name_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    [[nodiscard]] GLuint name() const { return name_; }

  private:
    GLuint name_;
};

struct BufferKind {
    static GLuint make() {
        GLuint name = 0;
        functions().GenBuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { functions().DeleteBuffers(1, &name); }
};

struct TextureKind {
    static GLuint make() {
        GLuint name = 0;
        functions().GenTextures(1, &name);
        return name;
    }
    static void destroy(GLuint name) { functions().DeleteTextures(1, &name); }
};

struct FramebufferKind {
    static GLuint make() {
        GLuint name = 0;
        functions().GenFramebuffers(1, &name);
        return name;
    }
    static void destroy(GLuint name) { functions().DeleteFramebuffers(1, &name); }
};

struct VertexArrayKind {
    static GLuint make() {
        GLuint name = 0;
        functions().GenVertexArrays(1, &name);
        return name;
    }
    static void destroy(GLuint name) { functions().DeleteVertexArrays(1, &name); }
};

struct ProgramKind {
    static GLuint make() { return functions().CreateProgram(); }
    static void destroy(GLuint name) { functions().DeleteProgram(name); }
};

using Buffer = Handle<BufferKind>;
using Texture = Handle<TextureKind>;
using Framebuffer = Handle<FramebufferKind>;
using VertexArray = Handle<VertexArrayKind>;

}  // namespace fumon::gl
