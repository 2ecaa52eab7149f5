#include "app/cli/doctor.h"

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/version.h"
#include "core/base/exit_status.h"
#include "core/base/parallel_for.h"
#include "core/base/text_format.h"
#include "core/platform/child_process.h"
#include "render/files/video_file.h"
#include "render/gl/context.h"
#include "scb/error.h"
#include "scb/simd_level.h"
#include "scenes/meshes/isolated_mesh.h"

namespace scb::app {
namespace {

DoctorFinding gl_finding(render::GlBackend backend) {
    DoctorFinding finding{.name = std::string(to_string(backend))};
    try {
        const render::GlInfo info = render::Context(backend).info();
        finding.works = true;
        finding.text = "OpenGL " + info.version + ", " + info.renderer + ", Mesa " + info.mesa +
                       ", LLVM " + info.llvm;
    } catch (const render::GlError& error) {
        finding.text = error.what();
        finding.remedy =
            !render::is_compiled_in(backend)
                ? "build scb where the package " +
                      std::string(backend == render::GlBackend::osmesa ? "libosmesa6-dev"
                                                                       : "libegl-dev") +
                      " is"
            : backend == render::GlBackend::osmesa
                ? "apt-get install libosmesa6"
                : "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri";
    } catch (const render::DrawError& error) {
        finding.text = error.what();
    }
    return finding;
}

DoctorFinding reader_finding() {
    DoctorFinding finding{.name = "meshes"};
    try {
        // This file exists but is no mesh. An InputError shows that the reader process works.
        scenes::isolated_mesh("/proc/self/exe");
    } catch (const InputError&) {
        finding.works = true;
        finding.text = "read in a process of their own, which is confined";
    } catch (const scenes::MeshReaderError& error) {
        finding.text = error.what();
    }
    return finding;
}

DoctorFinding program_finding(const std::string& program, const std::string& use,
                              const std::string& package) {
    const bool works = is_on_path(program);
    return {program, works, true, use, works ? "" : "apt-get install " + package};
}

DoctorFinding models_finding() {
    const char* folder = std::getenv("SCB_MODELS");
    const bool is_set = folder != nullptr && *folder != '\0';
    if (!is_set)
        return {"models", false, true, "SCB_MODELS is not set; some built-in scenes need meshes",
                "export SCB_MODELS=DIR"};
    std::error_code ignored;
    const bool works = std::filesystem::is_directory(folder, ignored);
    return {"models", works, true, folder + std::string(works ? "" : " is no folder"),
            works ? "" : "export SCB_MODELS=DIR"};
}

bool any_gl(const std::vector<DoctorFinding>& findings) {
    return findings[0].works || findings[1].works;
}

int status_of(const std::vector<DoctorFinding>& findings) {
    if (!any_gl(findings)) return exit_no_gl;
    for (const DoctorFinding& finding : findings)
        if (!finding.works && !finding.is_optional) return exit_environment;
    return exit_done;
}

std::string word_for(const DoctorFinding& finding) {
    return finding.works ? "works" : finding.is_optional ? "missing" : "fails";
}

std::string findings_text(const std::vector<DoctorFinding>& findings) {
    std::string text = "scb " SCB_VERSION ", " + compiler_text() + "\n\n";
    for (const DoctorFinding& finding : findings) {
        text += left_aligned(word_for(finding), 9) + left_aligned(finding.name, 11) + finding.text +
                "\n";
        if (!finding.remedy.empty())
            text += std::string(20, ' ') + "to have it: " + finding.remedy + "\n";
    }
    const bool draws = any_gl(findings);
    return text +
           (draws ? "\nPictures can be drawn." : "\nNo picture can be drawn: no OpenGL context.") +
           "\n";
}

std::string findings_json(const std::vector<DoctorFinding>& findings) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    for (const DoctorFinding& finding : findings) {
        Json entry = {{"name", finding.name},
                      {"state", word_for(finding)},
                      {"optional", finding.is_optional},
                      {"text", finding.text}};
        if (!finding.remedy.empty()) entry["remedy"] = finding.remedy;
        list.push_back(entry);
    }
    return Json{{"version", SCB_VERSION},
                {"compiler", compiler_text()},
                {"draws", any_gl(findings)},
                {"findings", list}}
               .dump(2) +
           "\n";
}

}  // namespace

std::vector<DoctorFinding> doctor_findings() {
    std::vector<DoctorFinding> findings = {gl_finding(render::GlBackend::osmesa),
                                           gl_finding(render::GlBackend::egl)};
    // Pictures need only one of the two.
    const bool draws = any_gl(findings);
    findings[0].is_optional = findings[1].is_optional = draws;
    findings.push_back({"fonts", true, false, "Roboto, in the program itself", ""});
    const SimdLevel best = available_simd_levels().back();
    const int processors = processor_count();
    findings.push_back({"processor", true, false,
                        std::to_string(processors) + (processors == 1 ? " thread" : " threads") +
                            ", vector instructions " + std::string(simd_level_name(best)),
                        ""});
    findings.push_back(reader_finding());
    findings.push_back(program_finding(render::video_program, "makes videos (--video)", "ffmpeg"));
    findings.push_back(program_finding("xdg-open", "opens what was made (--open)", "xdg-utils"));
    findings.push_back(models_finding());
    return findings;
}

void add_doctor(const Command& program, Action& action) {
    const Command command = program.add_subcommand(
        "doctor", "Check whether this machine has everything that scb needs");
    const auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "Print JSON instead of text");
    command.footer(
        "Exit status: 0 all that is needed works; 3 meshes cannot be read; 77 no OpenGL "
        "context.\n\nExample:\n  scb doctor");
    command.callback([&action, json] {
        action = [json] {
            const std::vector<DoctorFinding> findings = doctor_findings();
            print_result(*json ? findings_json(findings) : findings_text(findings));
            return status_of(findings);
        };
    });
}

}  // namespace scb::app
