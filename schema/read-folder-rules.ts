import { checkFolderRules } from './check-shape.ts';
import { withoutExtensions } from './extensions.ts';
import type { Problem } from './problem.ts';
import { readJson, toProblems } from './read-json.ts';
import type { OwnRules } from './rules.ts';

export type FolderRulesReading =
  | { readonly ok: true; readonly rules: OwnRules }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };

/**
 * Reads the rules that the configuration of a folder sets for its levels: its key `rules`, checked as a level's; its other keys are not looked at.
 * @param source the bytes of `gq.config.json`, or its text
 */
export function readFolderRules(source: Uint8Array | string): FolderRulesReading {
  const json = readJson(source, 'refuse');
  if (!json.ok) return json;
  const value = json.hasExtensions ? withoutExtensions(json.value) : json.value;
  const findings = [...json.findings, ...checkFolderRules(value)];
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, json.locator), text: json.text };
  return { ok: true, rules: (value as { readonly rules?: OwnRules }).rules ?? {} };
}
