import type { EventRule, Parts } from '../motion/index.ts';

/** A kind of event from what it has to say: {@link EventRule}. Its place in the order is given by {@link putInOrder}. */
export function eventRule(rule: Pick<EventRule, 'name' | 'fire'> & Partial<Omit<EventRule, 'kind'>>): EventRule {
  // named one by one, so that all have one shape and V8 need not search
  return {
    name: rule.name,
    kind: 0,
    ends: rule.ends ?? null,
    passing: rule.passing ?? false,
    keepsPeriod: rule.keepsPeriod ?? false,
    list: rule.list ?? null,
    guard: rule.guard ?? null,
    isOver: rule.isOver ?? null,
    quiet: rule.quiet ?? null,
    first: rule.first ?? null,
    always: rule.always ?? null,
    alwaysQuiet: rule.alwaysQuiet ?? null,
    fire: rule.fire,
  };
}

/** Numbers kinds of events in the order in which they happen when they fall on the same instant. */
export function putInOrder(rules: readonly EventRule[]): void {
  for (const [i, rule] of rules.entries()) rule.kind = i + 1;
}

/**
 * Lays out the kinds of events of the chosen effects.
 * @param all every kind there is, in order
 * @param listedFirst those with which the neighbour list begins, if they are chosen
 * @param chosen those that can happen
 */
export function layOutRules(
  all: readonly EventRule[],
  listedFirst: readonly EventRule[],
  chosen: readonly EventRule[],
): Pick<Parts, 'byKind' | 'list' | 'first' | 'always' | 'alwaysQuiet'> {
  const used = all.filter((rule) => chosen.includes(rule));
  const byKind: EventRule[] = [];
  for (const rule of all) byKind[rule.kind] = rule;
  return {
    byKind,
    list: [...new Set([...listedFirst, ...all])].filter((rule) => used.includes(rule) && rule.list !== null),
    first: used.filter((rule) => rule.first !== null),
    always: used.filter((rule) => rule.always !== null),
    alwaysQuiet: used.filter((rule) => rule.alwaysQuiet !== null),
  };
}
