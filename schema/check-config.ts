import { ADJUSTABLE_CODES, adjustmentOf, allCodes } from './adjustable.ts';
import { closestName } from './closest-name.ts';
import { configSchema, SEVERITIES, schemaOf } from './config.ts';
import { formatValue } from './format-value.ts';
import { type Finding, MAX_FINDINGS } from './problem.ts';
import { checkPart, codeFinding, found, isObject, unknownKey, unknownValue, wrongType } from './shape-findings.ts';

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

/** Checks a JSON value without x- keys against `configSchema`: keys, types, limits, codes and names. */
export function checkConfig(value: unknown): Finding[] {
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
      else checkPart(schemaOf(known, inner), inner, [known], value, findings);
    }
  }
  return findings;
}
