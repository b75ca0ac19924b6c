import * as z from 'zod';
import {
  ACCURACY_NAMES,
  ADJUSTABLE_CODES,
  adjustmentOf,
  allCodes,
  closestName,
  type Finding,
  formatValue,
  MAX_FINDINGS,
  type OwnRules,
  type Path,
  type Problem,
  REPORTER_NAMES,
  SEVERITIES,
  toWords,
} from '../basics/index.ts';
import { isObject, readJson, toProblems, withoutExtensions } from '../json/index.ts';
import {
  codeFinding,
  type Fault,
  findFaults,
  found,
  RULES_SHAPE,
  type Shape,
  tellFaults,
  unknownKey,
  unknownValue,
  wrongType,
} from '../level/index.ts';
import { type ConfigFile, configSchema, schemaOf } from './config.ts';

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

const KEYS = Object.keys(configSchema.shape) as (keyof typeof configSchema.shape)[];

const ONE_OR_LIST: Readonly<Record<string, string>> = {
  levels: 'a path in double quotes, or a list of them',
  ignore: 'a pattern in double quotes, or a list of them',
  cache: 'true, false, or a directory in double quotes',
};

function checkSeverity(severity: unknown, into: Finding[]): void {
  if (!isObject(severity)) {
    into.push(wrongType(['severity'], 'object', severity, 'severity: '));
    return;
  }
  for (const [code, value] of Object.entries(severity)) {
    if (into.length >= MAX_FINDINGS) return;
    const path = ['severity', code];
    const adjustment = adjustmentOf(code);
    if (adjustment === null || adjustment.severity === 'fixed') {
      into.push(codeFinding(path, adjustment === null ? closestName(code, allCodes()) : null, ADJUSTABLE_CODES));
    } else if (!SEVERITIES.some((known) => known === value)) {
      into.push(unknownValue(path, SEVERITIES, value));
    }
  }
}

/** What zod finds wrong with the value of a key, as a fault like those of levels. */
function toFault(issue: z.core.$ZodIssue, key: string, whole: unknown): Fault {
  const path: Path = [key, ...(issue.path as Path)];
  const value = issue.path.length === 0 ? whole : (whole as readonly unknown[])[Number(issue.path[0])];
  switch (issue.code) {
    case 'invalid_type': {
      const type = (issue.expected === 'int' ? 'integer' : issue.expected) as Shape['type'];
      return { what: 'wrong-type', path, value, shape: { type } };
    }
    case 'too_big':
      return { what: 'too-big', path, value, shape: { most: Number(issue.maximum) } };
    case 'too_small':
      return { what: 'too-small', path, value, shape: { least: Number(issue.minimum) } };
    default:
      return { what: issue.code === 'invalid_format' ? 'wrong-form' : 'other-value', path, value, shape: {} };
  }
}

function faultsOf(key: keyof typeof configSchema.shape, value: unknown): Fault[] {
  const faults: Fault[] = [];
  if (key === 'rules') {
    findFaults(value, RULES_SHAPE, [key], (fault) => faults.push(fault));
    return faults;
  }
  const seen = new Set<string>();
  for (const issue of z.safeParse(schemaOf(key, value), value).error?.issues ?? []) {
    // one problem per value is enough: the first is the most basic one
    const at = issue.path.join('/');
    if (!seen.has(at)) faults.push(toFault(issue, key, value));
    seen.add(at);
  }
  return faults;
}

const isChoice = (path: Path): boolean => path[0] === 'accuracy' || (path[0] === 'reporters' && path.length === 2);

/** A value of the configuration that is no name of an accuracy or a reporter. */
function choice(path: Path, value: unknown): Finding {
  if (path[0] === 'accuracy') return unknownValue(path, ACCURACY_NAMES, value);
  if (typeof value === 'string' && REPORTER_NAMES.some((name) => value.startsWith(`${name}=`))) {
    const words = value.endsWith('=') ? 'found no file' : `found ${value.length} characters`;
    return found(
      path,
      'unknown-value',
      `${toWords(path)}: expected NAME=FILE, ${words}`,
      'Write the path of a file after the =, as in "junit=report.xml".',
    );
  }
  return unknownValue(path, REPORTER_NAMES, value);
}

function checkValue(key: keyof typeof configSchema.shape, inner: unknown, whole: unknown, into: Finding[]): void {
  for (const fault of faultsOf(key, inner)) {
    if (into.length >= MAX_FINDINGS) return;
    if (isChoice(fault.path)) into.push(choice(fault.path, fault.value));
    else tellFaults([fault], whole, into);
  }
}

/** Checks a JSON value without x- keys against `configSchema`: keys, types, limits, codes and names. */
function checkConfig(value: unknown): Finding[] {
  if (!isObject(value)) {
    const message = `expected the configuration of a folder (an object in { }), found ${formatValue(value)}`;
    return [found([], 'wrong-type', message, 'Write { "levels": "levels" }, or { }.')];
  }
  const findings: Finding[] = [];
  for (const [key, inner] of Object.entries(value)) {
    if (findings.length >= MAX_FINDINGS) break;
    const known = KEYS.find((one) => one === key);
    if (known === undefined) {
      findings.push(unknownKey([], key, value, KEYS).finding);
    } else if (known === 'severity') {
      checkSeverity(inner, findings);
    } else {
      const words = ONE_OR_LIST[known];
      const fits = typeof inner === 'string' || (known === 'cache' ? typeof inner === 'boolean' : Array.isArray(inner));
      if (words !== undefined && !fits) findings.push(wrongType([known], words, inner, `${known}: `));
      else checkValue(known, inner, value, findings);
    }
  }
  return findings;
}
