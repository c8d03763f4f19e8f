// Which program made the page, with which libraries.

import { element, section, table } from "./dom.js";

export function versionsPanel({ program, libraries }) {
  return section("Versions", false, element("p", {}, `shellmatch ${program.version}, ${program.compiler}, ${program.vector_code}`),
    table(null, libraries.map((l) => [l.name, l.version])));
}
