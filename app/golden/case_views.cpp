#include "app/golden/case_views.h"

#include "app/view/view_page.h"
#include "core/platform/output_file.h"

namespace scb::app {

void add_views(golden::SuiteResult& result, const std::filesystem::path& folder,
               const GoldenOptions& golden, const Console& console,
               const std::function<bool()>& go_on) {
    for (golden::CaseResult& c : result.cases) {
        if (c.traces.size() != 2 || c.view.empty() || !go_on()) continue;
        ViewOptions options;
        options.level.scene.models_dir = golden.models;
        options.level.picture.gl = golden.gl;
        for (const std::string& trace : c.traces)
            options.level.scene.names.push_back((folder / trace).string());
        options.names_in_commands = c.traces;
        std::string html;
        try {
            html = view_page(options, console);
        } catch (const std::exception& error) {  // a page must not prevent the report
            console.note("scb: " + c.name + " has no page of `scb view`: " + error.what());
            continue;
        }
        const std::string page = c.name + ".view.html";
        write_file_whole(folder / page, html);
        c.view.insert(0, page);
    }
}

}  // namespace scb::app
