#include "tools/run/health_output.hpp"

#include "tools/cli/console.hpp"
#include "tools/cli/interrupt.hpp"
#include "tools/cli/output_path.hpp"
#include "tools/health/health_page.hpp"
#include "tools/health/health_pictures.hpp"

namespace tumble::tools {

HealthOutput::HealthOutput(const Scene& scene, const RunOptions& options)
    : scene_(scene), renderer_(options.renderer), file_(open_output(options.report, options.force)), watch_(scene) {}

std::uint64_t HealthOutput::finish(const SceneWorld& built, const std::string& note) {
    report_ = make_health_report(scene_, built, watch_);
    report_.note = note;
    if (note.empty())
        draw_findings(
            scene_, renderer_, [] { return is_interrupted(); }, report_);
    if (!report_.picture_error.empty()) report_warning("the report has not all pictures: " + report_.picture_error);
    file_.write(health_page(report_));
    return file_.commit();
}

}  // namespace tumble::tools
