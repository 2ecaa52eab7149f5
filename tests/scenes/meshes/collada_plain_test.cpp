#include "scenes/meshes/collada_plain.h"

#include "scenes/meshes/left_out.h"
#include "scenes/meshes/mesh_file.h"
#include "scenes/meshes/xml_reader.h"
#include "tests/scenes/support.h"

namespace scb::scenes {
namespace {

/// A triangle in inches. `array` and `accessor` are attributes of these, `more` is a library, and
/// `instance` is in the node.
std::string triangle_dae(const std::string& array = R"(id="a" count="9")",
                         const std::string& accessor = R"(source="#a" count="3" stride="3")",
                         const std::string& more = "",
                         const std::string& instance = R"(<instance_geometry url="#g"/>)") {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>)" +
           more + R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array )" +
           array + R"(>0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor )" + accessor +
           R"(><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1">
<input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">)" +
           instance + R"(</node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

Mesh mesh_of_dae(const std::string& text) {
    const TemporaryFolder folder;
    return load_mesh(folder.write("a.dae", text));
}
std::string refused_dae(const std::string& text) {
    return refusal([&] { plain_collada(text, "a.dae"); });
}

const std::vector<Vec3> corners_of_dae = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

TEST(ColladaPlain, RefusesAnAccessorThatReachesBeyondItsArray) {
    EXPECT_EQ(mesh_of_dae(triangle_dae()).vertices, corners_of_dae);
    const std::string array = R"(id="a" count="9")";
    EXPECT_EQ(refused_dae(triangle_dae(R"(id="a" count="3")")),
              "a.dae: array \"a\" has 3 numbers, but its accessor needs 9; repair the counts.");
    for (const auto& [accessor, needed] :
         {std::pair(R"(source="#a" count="4" stride="3")", "needs 12"),
          std::pair(R"(source="#a" count="3" stride="4")", "needs 11"),
          std::pair(R"(source="#a" count="3" stride="3" offset="1")", "needs 10"),
          std::pair(R"(source="#a" count="4294967295" stride="4294967295")", "needs 184467")})
        expect_in(needed, refused_dae(triangle_dae(array, accessor)));
    for (const char* count : {"-1", "9x", "0x9", "", "4294967296"})
        expect_in("array \"a\": the count is \"" + std::string(count) + "\"",
                  refused_dae(triangle_dae("id=\"a\" count=\"" + std::string(count) + "\"")));
    expect_in("array \"b\", which an accessor reads, is not a float_array",
              refused_dae(triangle_dae(array, R"(source="#b" count="3" stride="3")")));
    expect_in("two arrays have the id \"a\"",
              refused_dae(triangle_dae(array + "/><float_array id=\"a\" count=\"1\"")));
    expect_in("has a line end or an entity", refused_dae(triangle_dae(R"(id="&#97;" count="9")")));
    // What is not read may be broken.
    EXPECT_EQ(
        mesh_of_dae(
            triangle_dae(array, R"(source="#a" count="3" stride="3")",
                         R"(<library_animations><animation><source id="t"><accessor source="#none"
count="x"/></source></animation></library_animations>)"))
            .vertices,
        corners_of_dae);
}

TEST(ColladaPlain, ReadsAFileWhoseImageHasNoName) {
    EXPECT_EQ(
        mesh_of_dae(
            triangle_dae(R"(id="a" count="9")", R"(source="#a" count="3" stride="3")",
                         R"(<library_images><image id="i"><init_from/></image></library_images>)",
                         R"(<instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#m"><bind_vertex_input semantic="U" input_semantic="TEXCOORD"/>
</instance_material></technique_common></bind_material></instance_geometry>)"))
            .vertices,
        corners_of_dae);
}

TEST(ColladaPlain, ReadsTheGeometryOfASkin) {
    const std::string skin =
        R"(<library_controllers><controller id="c"><skin source="#m"/></controller>
<controller id="m"><morph source="#g"/></controller></library_controllers>)";
    take_left_out();
    EXPECT_EQ(
        mesh_of_dae(
            triangle_dae(
                R"(id="a" count="9")", R"(source="#a" count="3" stride="3")", skin,
                R"(<instance_controller url="#c"><skeleton>#x</skeleton></instance_controller>)"))
            .vertices,
        corners_of_dae);
    const std::vector<std::string> notes = take_left_out();
    ASSERT_EQ(notes.size(), 1u);
    expect_in("a.dae: its skins and morph targets are left out", notes[0]);
}

TEST(ColladaPlain, RefusesXmlThatIsNotWellFormed) {
    expect_in("a.dae: line 2: the XML has an end without its start",
              refused_dae("<COLLADA>\n</x>"));
    for (const char* text : {"<COLLADA>", "<COLLADA", "<!-- ", "<a b></a>", "<a b=1></a>",
                             "<a b=\"1></a>", "< a></a>", "<a/>x", "x", "<![CDATA[x]]>", "</a>"})
        expect_in("the XML ", refused_dae(text));
}

TEST(XmlReader, GivesElementsAndTexts) {
    const std::string name = "a.xml";
    XmlReader reader(
        "\xEF\xBB\xBF<?xml?><!DOCTYPE a [<!ENTITY b \"c\">]><a x = '1>' y=\"2\"><!-- <b> -->t"
        "<![CDATA[<c>]]><d/></a >\n",
        name);
    const auto event = [&] { return reader.next().value(); };
    const XmlEvent a = event();
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(xml_attribute(a.attributes, "x"), "1>");
    EXPECT_EQ(xml_attribute(a.attributes, "y"), "2");
    EXPECT_FALSE(xml_attribute(a.attributes, "z"));
    EXPECT_EQ(event().content, "t");
    const XmlEvent raw = event();
    EXPECT_TRUE(raw.is_cdata);
    EXPECT_EQ(raw.content, "<c>");
    EXPECT_EQ(event().name, "d");
    EXPECT_EQ(event().kind, XmlEvent::end);
    EXPECT_EQ(event().name, "a");
    EXPECT_FALSE(reader.next());
}

}  // namespace
}  // namespace scb::scenes
