#pragma once

#include <string>

#include "app/inspect/inspect_report.h"

namespace scb::app {

/// What the page of `scb inspect -o` needs beside the report.
struct InspectPage {
    std::string summary;        ///< file name of the picture of the whole
    std::string bodies;         ///< and of that of the bodies; empty where there is none
    int width = 0, height = 0;  ///< of all pictures, in pixels
    bool light = true;          ///< the background of the pictures, which the page has too
    std::string command;        ///< that made it
    std::string explain;        ///< the command that explains a pair, up to the frame
    std::string view;           ///< file name of a page of `scb view`; empty where there is none
};

/// One HTML file; the pictures are files beside it.
std::string inspect_html(const InspectReport& report, const InspectPage& page);

/// "spheres-l1 · SCB · inspect", and "10 frames, test symmetric, A and B", as UTF-8.
std::string inspect_title(const InspectReport& report);
std::string inspect_subtitle(const InspectReport& report);

}  // namespace scb::app
