#include "record.h"

#include "embedded_files.h"
#include "error.h"
#include "json_reader.h"

namespace gnomon::verify {

namespace {

using Json = nlohmann::ordered_json;

Print print_of(Renderer& renderer, const Case& of, const Mode& mode) {
    Film film;
    render(renderer, of, mode, film);
    Print print{fingerprint(film), {}};
    Film shaded, shadowed;
    for (size_t light = 0; light < of.scene.lights.size(); ++light) {
        render_light(renderer, of, mode, light, false, shaded);
        render_light(renderer, of, mode, light, true, shadowed);
        print.lights.push_back({radiance_sha1(shaded), radiance_sha1(shadowed)});
    }
    return print;
}

Json to_json(const Print& print) {
    Json json;
    for (size_t r = 0; r < results.size(); ++r) json[results[r]] = print.picture.sha1[r];
    for (size_t kind = 0; kind < lines.size(); ++kind) json[lines[kind]] = print.picture.shorts[kind];
    json["lights"] = Json::array();
    for (const LightPrint& light : print.lights)
        json["lights"].push_back({{"shaded", light.shaded}, {"shadowed", light.shadowed}});
    return json;
}

Print print_from(const JsonReader& json) {
    JsonReader::Keys keys(results.begin(), results.end());
    keys.insert(keys.end(), lines.begin(), lines.end());
    keys.push_back("lights");
    json.expect_object("a picture", keys);
    Print print;
    for (size_t r = 0; r < results.size(); ++r) print.picture.sha1[r] = json[results[r]].text();
    for (size_t kind = 0; kind < lines.size(); ++kind) print.picture.shorts[kind] = json[lines[kind]].text();
    const JsonReader all = json["lights"];
    for (size_t i = 0; i < all.array_size(); ++i) {
        all[i].expect_object("a light", {"shaded", "shadowed"});
        print.lights.push_back({all[i]["shaded"].text(), all[i]["shadowed"].text()});
    }
    return print;
}

}  // namespace

Record record(const DeviceInfo& device, const Say& say) {
    check_accuracy(Accuracy::full, device);
    DeviceInfo without = device;
    without.fp64 = false;  // its fp64 is then left alone
    Renderer renderer(device), renderer_without(without);
    Record made;
    for (const bool quick : {false, true})
        for (const Case& of : cases(quick))
            for (const Mode& mode : recorded_modes()) {
                if (!of.has(mode.accuracy)) continue;
                const std::string name = picture_name(of, mode);
                say(name);
                made[name] = print_of(mode.fp64 ? renderer : renderer_without, of, mode);
            }
    return made;
}

const Record& recorded() {
    static const Record read = parse_record(embedded_verify_files().at("recorded.json"), "recorded.json");
    return read;
}

std::string to_text(const Record& record) {
    std::string text;
    for (const auto& [name, print] : record)
        text += (text.empty() ? "" : ",\n") + Json(name).dump() + ": " + to_json(print).dump();
    return "{\n" + text + "\n}\n";
}

Record parse_record(const std::string& text, const std::string& name) {
    const nlohmann::json document = parse_json(text, name);
    const JsonReader all(document, name);
    if (!all.is_object()) all.refuse("an object of pictures");
    Record record;
    for (const auto& [picture, value] : document.items()) record[picture] = print_from(all[picture]);
    return record;
}

}  // namespace gnomon::verify
