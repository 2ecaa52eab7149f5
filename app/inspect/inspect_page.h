#pragma once

#include <string>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// Data of the page of `scb inspect -o` besides the report.
struct InspectPage {
    std::string summary;        ///< file name of the picture of all frames
    std::string bodies;         ///< file name of the picture of the bodies; empty if there is none
    int width = 0, height = 0;  ///< of all pictures, in pixels
    bool light = true;          ///< the background of the pictures and of the page
    std::string command;        ///< the command that made the page
    std::string explain;        ///< the command that explains a pair, without the frame
    std::string view;           ///< file name of a page of `scb view`; empty if there is none
};

/// One HTML file; its pictures are files beside it.
std::string inspect_html(const InspectReport& report, const InspectPage& page);

/// "spheres-l1 · SCB · inspect", and "10 frames, test symmetric, A and B", as UTF-8.
std::string inspect_title(const InspectReport& report);
std::string inspect_subtitle(const InspectReport& report);

}  // namespace scb::app
