#include "render/canvas/canvas.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "debug/check.hpp"
namespace tumble::render {
namespace {

std::size_t byte_count(int width, int height) {
    return 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

void resize(Image& image, int width, int height) {
    image.width = width;
    image.height = height;
    image.rgba.resize(byte_count(width, height));
}

}  // namespace

Canvas::Canvas(std::unique_ptr<OffscreenContext> context, int width, int height)
    : context_(std::move(context)), width_(width), height_(height) {
    resize(first_, width, height);
    context_->bind(first_.rgba.data(), width, height);
    gl_ = load_gl_api(*context_);

    const auto color = [](std::size_t offset) { return Attribute{4, GL_UNSIGNED_BYTE, offset}; };
    const auto floats = [](GLint components, std::size_t offset) { return Attribute{components, GL_FLOAT, offset}; };

    const Attribute circle[] = {color(offsetof(CircleInstance, paint.fill)),
                                color(offsetof(CircleInstance, paint.outline)), floats(3, 0)};
    circles_ = make_pipeline(circle_shader(), circle, sizeof(CircleInstance), true);

    const Attribute box[] = {color(offsetof(BoxInstance, paint.fill)), color(offsetof(BoxInstance, paint.outline)),
                             floats(4, 0), floats(3, offsetof(BoxInstance, half_x))};
    boxes_ = make_pipeline(box_shader(), box, sizeof(BoxInstance), true);

    const std::size_t vertices = offsetof(PolygonInstance, vertices);
    const Attribute polygon[] = {color(offsetof(PolygonInstance, paint.fill)),
                                 color(offsetof(PolygonInstance, paint.outline)),
                                 floats(4, 0),
                                 floats(3, offsetof(PolygonInstance, half_x)),
                                 floats(4, vertices),
                                 floats(4, vertices + 4 * sizeof(float)),
                                 floats(4, vertices + 8 * sizeof(float)),
                                 floats(4, vertices + 12 * sizeof(float))};
    polygons_ = make_pipeline(polygon_shader(), polygon, sizeof(PolygonInstance), true);
    rounded_polygons_ = make_pipeline(rounded_polygon_shader(), polygon, sizeof(PolygonInstance), true);

    const Attribute vertex[] = {color(offsetof(MeshVertex, paint.fill)), color(offsetof(MeshVertex, paint.outline)),
                                floats(3, 0)};
    mesh_ = make_pipeline(mesh_shader(), vertex, sizeof(MeshVertex), false);

    const Attribute image[] = {floats(4, 0), floats(4, offsetof(ImageInstance, half_x))};
    images_ = make_pipeline(image_shader(), image, sizeof(ImageInstance), true);

    const Attribute glyph[] = {color(offsetof(GlyphInstance, color)), floats(4, 0),
                               floats(2, offsetof(GlyphInstance, atlas_x))};
    glyphs_ = make_pipeline(glyph_shader(), glyph, sizeof(GlyphInstance), true);

    gl_.GenTextures(1, &atlas_texture_);
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);

    gl_.Viewport(0, 0, width, height);
    gl_.Disable(GL_DITHER);
    gl_.Enable(GL_BLEND);
    gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // colours are premultiplied
    gl_.Finish();
}

std::string Canvas::text_of(GLenum name) const {
    const GLubyte* const text = gl_.GetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

GLuint Canvas::compile(GLenum stage, const char* name, const std::string& source) {
    const GLuint shader = gl_.CreateShader(stage);
    const char* const text = source.c_str();
    gl_.ShaderSource(shader, 1, &text, nullptr);
    gl_.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    char log[1024] = {};
    gl_.GetShaderInfoLog(shader, sizeof log, nullptr, log);
    throw RenderError(std::string("the shader for ") + name + " does not compile: " + log);
}

Canvas::Pipeline Canvas::make_pipeline(const ShaderSource& source, std::span<const Attribute> attributes,
                                       std::size_t stride, bool instanced) {
    const GLuint vertex = compile(GL_VERTEX_SHADER, source.name, source.vertex);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, source.name, source.fragment);
    Pipeline pipeline;
    pipeline.program = gl_.CreateProgram();
    gl_.AttachShader(pipeline.program, vertex);
    gl_.AttachShader(pipeline.program, fragment);
    gl_.LinkProgram(pipeline.program);
    gl_.DeleteShader(vertex);
    gl_.DeleteShader(fragment);
    GLint linked = GL_FALSE;
    gl_.GetProgramiv(pipeline.program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[1024] = {};
        gl_.GetProgramInfoLog(pipeline.program, sizeof log, nullptr, log);
        throw RenderError(std::string("the program for ") + source.name + " does not link: " + log);
    }
    pipeline.to_clip = gl_.GetUniformLocation(pipeline.program, "to_clip");
    pipeline.outline_width = gl_.GetUniformLocation(pipeline.program, "outline_width");

    gl_.GenVertexArrays(1, &pipeline.vertex_array);
    gl_.GenBuffers(1, &pipeline.buffer);
    gl_.BindVertexArray(pipeline.vertex_array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, pipeline.buffer);
    for (GLuint i = 0; i < attributes.size(); ++i) {
        const Attribute& attribute = attributes[i];
        TUMBLE_CHECK(attribute.offset < stride);
        const GLboolean normalized = attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;
        gl_.VertexAttribPointer(i, attribute.components, attribute.type, normalized, static_cast<GLsizei>(stride),
                                reinterpret_cast<const void*>(attribute.offset));
        gl_.EnableVertexAttribArray(i);
        if (instanced) gl_.VertexAttribDivisor(i, 1);
    }
    return pipeline;
}

void Canvas::draw(Color background, std::span<const Layer* const> layers, const GlyphAtlas& atlas, Image& image) {
    resize(image, width_, height_);
    TUMBLE_CHECK(image.rgba.size() == byte_count(width_, height_));
    context_->bind(image.rgba.data(), width_, height_);
    gl_.ClearColor(static_cast<float>(background.r) / 255.0f, static_cast<float>(background.g) / 255.0f,
                   static_cast<float>(background.b) / 255.0f, 1.0f);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    update_atlas(atlas);
    for (const Layer* const layer : layers) draw_layer(*layer);
    gl_.Finish();
    context_->finish();
    if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR)
        throw RenderError("OpenGL reports error " + std::to_string(error) + " while drawing a frame");
}

void Canvas::draw_layer(const Layer& layer) {
    draw_mesh(layer.mesh, layer.outline_width);
    draw_instances(polygons_, layer.polygons, layer.outline_width);
    draw_instances(rounded_polygons_, layer.rounded_polygons, layer.outline_width);
    draw_instances(boxes_, layer.boxes, layer.outline_width);
    draw_instances(circles_, layer.circles, layer.outline_width);
    draw_images(layer.images);
    draw_instances(glyphs_, layer.glyphs, layer.outline_width);
}

void Canvas::use(const Pipeline& pipeline, double outline_width) {
    gl_.UseProgram(pipeline.program);
    gl_.BindVertexArray(pipeline.vertex_array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, pipeline.buffer);
    gl_.Uniform2f(pipeline.to_clip, 2.0f / static_cast<float>(width_), 2.0f / static_cast<float>(height_));
    gl_.Uniform1f(pipeline.outline_width, static_cast<float>(outline_width));
}

template <class Instance>
void Canvas::draw_instances(const Pipeline& pipeline, const std::vector<Instance>& instances, double outline_width) {
    if (instances.empty()) return;
    use(pipeline, outline_width);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)), instances.data(),
                   GL_STREAM_DRAW);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
}

void Canvas::draw_mesh(const std::vector<MeshVertex>& vertices, double outline_width) {
    if (vertices.empty()) return;
    TUMBLE_CHECK(vertices.size() % 3 == 0);
    use(mesh_, outline_width);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(MeshVertex)), vertices.data(),
                   GL_STREAM_DRAW);
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

// One after the other: each may have a texture of its own, and covers those before it.
void Canvas::draw_images(const std::vector<ImageInstance>& images) {
    for (const ImageInstance& image : images) {
        gl_.BindTexture(GL_TEXTURE_2D, texture_of(*image.pixels));
        draw_instances(images_, std::vector{image}, 0.0);
    }
    if (!images.empty()) gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
}

GLuint Canvas::texture_of(const Image& image) {
    if (const auto known = textures_.find(&image); known != textures_.end()) return known->second;
    std::vector<std::uint8_t> texels = image.rgba;
    for (std::size_t i = 0; i + 3 < texels.size(); i += 4)
        for (std::size_t channel = i; channel < i + 3; ++channel)
            texels[channel] = static_cast<std::uint8_t>((texels[channel] * texels[i + 3] + 127) / 255);
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
    gl_.GenerateMipmap(GL_TEXTURE_2D);
    return textures_.emplace(&image, texture).first->second;
}

void Canvas::forget_images() {
    for (const auto& [image, texture] : textures_) gl_.DeleteTextures(1, &texture);
    textures_.clear();
}

void Canvas::update_atlas(const GlyphAtlas& atlas) {
    if (atlas.revision() == atlas_revision_) return;
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, GlyphAtlas::kWidth, atlas.height(), 0, GL_RED, GL_UNSIGNED_BYTE,
                   atlas.texels().data());
    atlas_revision_ = atlas.revision();
}

}  // namespace tumble::render
