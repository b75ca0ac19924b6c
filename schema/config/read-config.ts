import type { OwnRules } from '../basics/default-rules.ts';
import type { Problem } from '../basics/problem.ts';
import { withoutExtensions } from '../json/extensions.ts';
import { readJson, toProblems } from '../json/read-json.ts';
import { checkConfig } from './check-config.ts';
import type { ConfigFile } from './config.ts';

/** The outcome of {@link readConfig}: with `ok` true the configuration, otherwise the problems. */
export type ConfigReading =
  | {
      /** The configuration could be read. */
      readonly ok: true;
      /** What it says, without x- keys. */
      readonly config: ConfigFile;
    }
  | {
      /** The configuration is not valid. */
      readonly ok: false;
      /** What is wrong with it, in the order of the text; at least one. */
      readonly problems: Problem[];
      /** The text without a byte order mark; '' if the file is too large or not a text. */
      readonly text: string;
      /** The rules that it sets, if nothing is wrong with those; else null. */
      readonly rules: OwnRules | null;
    };

/**
 * Reads the configuration of a folder: encoding, JSON syntax, keys, types, limits, names. Throws nothing for any content.
 *
 * @param source - the bytes of `gq.config.json`, or its text
 * @returns the configuration, or every problem found, each with its place
 */
export function readConfig(source: Uint8Array | string): ConfigReading {
  const json = readJson(source, 'skip', 'configuration');
  if (!json.ok) return { ...json, rules: null };
  const value = json.hasExtensions ? withoutExtensions(json.value) : json.value;
  const findings = [...json.findings, ...checkConfig(value)];
  if (findings.length === 0) return { ok: true, config: value as ConfigFile };
  const areRulesFine = json.findings.length === 0 && findings.every(({ path }) => path.length > 0 && path[0] !== 'rules');
  const rules = areRulesFine ? ((value as ConfigFile).rules ?? {}) : null;
  return { ok: false, problems: toProblems(findings, json.locator), text: json.text, rules };
}
