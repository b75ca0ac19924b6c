import { checkFolderRules } from './check-shape.ts';
import { withoutExtensions } from './extensions.ts';
import type { Problem } from './problem.ts';
import { readJson, toProblems } from './read-json.ts';
import type { OwnRules } from './rules.ts';

/** The outcome of {@link readFolderRules}: with `ok` true the rules, otherwise the problems. */
export type FolderRulesReading =
  | {
      /** The configuration could be read. */
      readonly ok: true;
      /** The rules that it sets. */
      readonly rules: OwnRules;
    }
  | {
      /** The configuration is not valid. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
    };

/**
 * Reads the rules that a folder's configuration sets for its levels. Only the key `rules` is examined; it is checked as in a
 * level file. Throws nothing for any content.
 *
 * @param source - the bytes of `gq.config.json`, or its text
 * @returns the rules, or what is wrong
 */
export function readFolderRules(source: Uint8Array | string): FolderRulesReading {
  const json = readJson(source, 'refuse');
  if (!json.ok) return json;
  const value = json.hasExtensions ? withoutExtensions(json.value) : json.value;
  const findings = [...json.findings, ...checkFolderRules(value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, json.locator), text: json.text };
  return { ok: true, rules: (value as { readonly rules?: OwnRules }).rules ?? {} };
}
