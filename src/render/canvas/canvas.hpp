// Draws layers of primitives with OpenGL 3.3 into an image.
//
// Each kind of primitive has a program, a vertex array and a buffer. The layers are uploaded and drawn one after the
// other. The GL objects belong to the context and are destroyed with it.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>

#include "render/canvas/gl_api.hpp"
#include "render/canvas/glyph_atlas.hpp"
#include "render/canvas/offscreen_context.hpp"
#include "render/canvas/primitives.hpp"
#include "render/canvas/shaders.hpp"
#include "tumble/render.hpp"

namespace tumble::render {

class Canvas {
public:
    // Throws RenderError if there is no context or a program does not compile.
    Canvas(std::unique_ptr<OffscreenContext> context, int width, int height);

    // Draws the layers in order, each over those before, into `image`, which is resized to the canvas.
    void draw(Color background, std::span<const Layer* const> layers, const GlyphAtlas& atlas, Image& image);

    // Deletes the textures of images. To be called before an image that was drawn is destroyed or changed.
    void forget_images();

    // What OpenGL says of itself.
    std::string version() const { return text_of(GL_VERSION); }
    std::string renderer() const { return text_of(GL_RENDERER); }

private:
    // The position of a vertex attribute in an instance or a mesh vertex.
    struct Attribute {
        GLint components;
        GLenum type;  // GL_FLOAT, or GL_UNSIGNED_BYTE for a colour
        std::size_t offset;
    };
    // A program with the buffer that feeds it.
    struct Pipeline {
        GLuint program = 0;
        GLuint vertex_array = 0;
        GLuint buffer = 0;
        GLint to_clip = -1;
        GLint outline_width = -1;
    };

    std::string text_of(GLenum name) const;
    GLuint compile(GLenum stage, const char* name, const std::string& source);
    Pipeline make_pipeline(const ShaderSource& source, std::span<const Attribute> attributes, std::size_t stride,
                           bool instanced);
    void use(const Pipeline& pipeline, double outline_width);
    void draw_layer(const Layer& layer);
    template <class Instance>
    void draw_instances(const Pipeline& pipeline, const std::vector<Instance>& instances, double outline_width);
    void draw_mesh(const std::vector<MeshVertex>& vertices, double outline_width);
    void draw_images(const std::vector<ImageInstance>& images);
    GLuint texture_of(const Image& image);
    void update_atlas(const GlyphAtlas& atlas);

    std::unique_ptr<OffscreenContext> context_;
    int width_ = 0;
    int height_ = 0;
    Image first_;  // the target of the context until the first call of draw()
    GlApi gl_;
    Pipeline circles_, boxes_, polygons_, rounded_polygons_, mesh_, images_, glyphs_;
    std::map<const Image*, GLuint> textures_;
    GLuint atlas_texture_ = 0;
    std::uint64_t atlas_revision_ = 0;
};

}  // namespace tumble::render
