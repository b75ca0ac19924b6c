import type { Proof } from '../../solver/index.ts';

type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** A proof with one value of its certificate changed: a number a little or a lot, a name, or a part left out or duplicated. */
export function mutated(proof: Proof, random: () => number): Proof {
  const certificate = JSON.parse(JSON.stringify(proof.certificate)) as { [key: string]: Json };
  const places: [holder: { [key: string]: Json }, key: string][] = [];
  const look = (json: Json) => {
    if (json === null || typeof json !== 'object') return;
    for (const key of Object.keys(json)) {
      const holder = json as { [key: string]: Json };
      if (key === 'kind' && json === certificate) continue;
      places.push([holder, key]);
      look(holder[key]);
    }
  };
  look(certificate);
  if (places.length === 0) return { ...proof, maxTime: 100 * random() };
  const [holder, key] = places[Math.floor(random() * places.length)];
  holder[key] = change(holder[key], random);
  return { ...proof, certificate: certificate as unknown as Proof['certificate'] };
}

function change(old: Json, random: () => number): Json {
  const pick = <T>(...of: T[]): T => of[Math.floor(random() * of.length)];
  if (typeof old === 'number') {
    const by = pick(1e-9, 1e-3, 0.1, 1, 10, 100) * (random() - 0.5);
    return pick(old + by, old * (1 + by), -old, old / 2, Math.round(old) + pick(-1, 1), 0);
  }
  if (typeof old === 'string') return pick('nova', 'asteroid', 'alien', 'blackHole', 'range', 'start', 'dead-end');
  if (Array.isArray(old)) return pick([...old].reverse(), old.slice(1), [...old, ...old], []);
  return pick<Json>(null, { kind: 'range' }, { kind: 'nova', index: 0 }, { kind: 'start' }, { kind: 'asteroid', index: 0 });
}
