#include "tools/compare/compared_pictures.hpp"

#include <array>
#include <utility>

#include "tools/cli/interrupt.hpp"
#include "tools/output/image_grid.hpp"
#include "tools/output/plot_colors.hpp"

namespace tumble::tools {

namespace {

constexpr int kPairGap = 4;  // px between the pictures

// Draws both runs in their present state.
class PairPainter {
public:
    PairPainter(const ComparedSources& sources, const PairPictures& pictures)
        : sources_(sources),
          pictures_(pictures),
          overlay_(pictures.overlay),
          renderer_(pictures.size.width, pictures.size.height, pictures.renderer) {
        const Theme theme = theme_of(*sources.a->scene(), pictures);
        overlay_.theme = theme;
        behind_ = color_of(kPageColor, is_dark(theme));
    }

    Image draw(const Camera& camera, double time) {
        std::vector<std::string> caption_b = sources_.notes;
        caption_b.insert(caption_b.begin(), sources_.name_b);
        const std::array<Image, 2> images{draw_one(*sources_.a, {sources_.name_a}, camera, time),
                                          draw_one(*sources_.b, caption_b, camera, time)};
        return pictures_.is_overlaid ? mean_of(images[0], images[1]) : image_grid(images, 2, kPairGap, behind_);
    }

private:
    Image draw_one(const StateSource& source, const std::vector<std::string>& caption, const Camera& camera,
                   double time) {
        Image image;
        const Marking marking{.caption = pictures_.is_overlaid ? std::vector<std::string>{} : caption};
        renderer_.draw(*source.scene(), *source.built(), camera, time, image, overlay_, marking);
        return image;
    }

    const ComparedSources& sources_;
    const PairPictures& pictures_;
    Overlay overlay_;
    Color behind_;
    Renderer renderer_;
};

}  // namespace

Theme theme_of(const Scene& a, const PairPictures& pictures) {
    return pictures.overlay.theme.value_or(a.camera.style.theme);
}

FrameSize pair_size(const PairPictures& pictures) {
    const auto [width, height] = pictures.size;
    return {pictures.is_overlaid ? width : 2 * width + kPairGap, height};
}

void draw_pairs(const CompareInputs& inputs, const PairPictures& pictures,
                const std::function<bool(std::uint64_t step)>& is_wanted,
                const std::function<void(PairPicture)>& take) {
    const ComparedSources sources = open_sources(inputs);
    if (!sources.a->built() || !sources.b->built()) return;
    const Scene& scene = *sources.a->scene();
    PairPainter painter(sources, pictures);
    Camera camera = make_camera(scene, *sources.a->built(), pictures.size.aspect_ratio());
    StepStates a, b;
    while (!is_interrupted() && sources.a->next(a) && sources.b->next(b) && a.step == b.step) {
        if (a.step > 0) camera = move_camera(camera, scene, *sources.a->built());
        if (!is_wanted(a.step)) continue;
        const Camera shown = apply_camera_keys(camera, scene, *sources.a->built(), pictures.size.aspect_ratio());
        take({a.step, a.time, painter.draw(shown, a.time)});
    }
}

}  // namespace tumble::tools
