#pragma once

#include <vector>

#include "gl/handles.h"

namespace fumon::gl {

/// A buffer whose content changes from frame to frame. Its storage is kept while the content fits.
class DynamicBuffer {
  public:
    explicit DynamicBuffer(GLenum target) : target_(target) {}

    void bind() const { functions().BindBuffer(target_, buffer_.name()); }

    /// Binds it and replaces its content.
    template <class Element>
    void fill(const std::vector<Element>& elements) {
        bind();
        const auto size = static_cast<GLsizeiptr>(elements.size() * sizeof(Element));
        if (size > capacity_) {
            capacity_ = size + size / 4;  // room to grow
            functions().BufferData(target_, capacity_, nullptr, GL_DYNAMIC_DRAW);
        }
        if (size > 0) functions().BufferSubData(target_, 0, size, elements.data());
    }

  private:
    Buffer buffer_;
    GLenum target_;
    GLsizeiptr capacity_ = 0;
};

}  // namespace fumon::gl
