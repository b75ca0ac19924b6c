import { type Path, type Problem, toPointer } from '../basics/problem.ts';
import { withoutExtensions } from '../json/extensions.ts';
import { readJson, toProblems } from '../json/read-json.ts';
import type { TextPlace } from '../json/text-place.ts';
import { checkPackShape } from './check-pack.ts';
import type { PackFile } from './pack.ts';

/** The outcome of {@link readPack}: with `ok` true the pack, otherwise the problems. */
export type PackReading =
  | {
      /** The file is a valid pack. */
      readonly ok: true;
      /** The pack as the file has it, with its x- keys. */
      readonly pack: PackFile;
      /** The text without a byte order mark. */
      readonly text: string;
      /**
       * Finds a place in the text.
       *
       * @param path - keys and indices from the root
       * @returns the pointer of the value that the path names, and its line and column
       */
      locate(path: Path): TextPlace & { readonly pointer: string };
    }
  | {
      /** The file is not a valid pack. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/**
 * Reads a pack file: encoding, JSON syntax, version, keys, types, limits. Throws nothing for any content.
 *
 * @param source - the bytes of `pack.json`, or its text
 * @returns the pack, or every problem found, each with its place
 */
export function readPack(source: Uint8Array | string): PackReading {
  const json = readJson(source, 'skip', 'pack');
  if (!json.ok) return json;
  const { text, locator, value, hasExtensions } = json;
  const findings = [...json.findings, ...checkPackShape(hasExtensions ? withoutExtensions(value) : value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };
  const locate = (path: Path) => {
    const pointer = toPointer(path);
    return { pointer, ...locator.placeAt(locator.offsetOf(pointer, 'value')) };
  };
  return { ok: true, pack: value as PackFile, text, locate };
}
