import { decodePlay, type Play, type VerifiedPlay, type VerifyOptions } from '../../game/index.ts';
import { whyOtherAccuracy } from '../../game/play/index.ts';
import type { OwnRules, VerifyReport } from '../../schema/index.ts';
import { type Candidate, type Catalogue, candidateFor, type KnownLevel, readCatalogue } from './catalogue.ts';
import { enginesIn, loadEngine, ownEngine } from './engine-module.ts';
import type { ReplayTask } from './replay.ts';
import type { Threads } from './threads.ts';

/** A play to verify, and where it comes from. */
export interface PlayItem {
  readonly file: string | null;
  readonly line: number | null;
  readonly id: string | number | null;
  /** For whom its challenge must have been given. */
  readonly subject: string | null;
  /** The bytes, or why there are none. */
  readonly content: Uint8Array | { readonly verdict: 'malformed' | 'too-long'; readonly why: string };
}

/** What plays are verified with. */
export interface PlaySettings {
  readonly files: readonly string[];
  readonly rules: OwnRules;
  /** The folder with older engines; null: there is none. */
  readonly engines: string | null;
  /** The name of the accuracy at which plays must have been played, or `any`. */
  readonly accuracy: string;
  readonly options: Omit<VerifyOptions, 'accuracy'>;
  /** How many stale plays are tried on the levels that there are. */
  readonly candidates: number;
}

/** A report, or a task whose result completes it. */
type Prepared =
  | { readonly report: VerifyReport }
  | { readonly task: ReplayTask; complete(verified: VerifiedPlay | null): VerifyReport };

/** An older engine: the levels as it sees them, and the folder with its built files. */
interface OlderEngine {
  readonly catalogue: Catalogue;
  readonly folder: string;
}

const NOTHING = { found: null, time: null, differs: null, challenge: null, signs: null } as const;

/** Verifies plays against levels. */
export class PlayDesk {
  readonly catalogue: Catalogue;
  /** Where older engines are. */
  private readonly engines: ReadonlyMap<string, string>;
  /** Those that were asked for. */
  private readonly older = new Map<string, Promise<OlderEngine>>();
  private candidatesLeft: number;

  constructor(
    private readonly settings: PlaySettings,
    private readonly threads: Threads,
  ) {
    this.engines = settings.engines === null ? new Map() : enginesIn(settings.engines);
    this.catalogue = readCatalogue(settings.files, settings.rules, ownEngine);
    this.candidatesLeft = settings.candidates;
  }

  /** @returns a report for each play, in their order */
  async verify(items: readonly PlayItem[]): Promise<VerifyReport[]> {
    const prepared: Prepared[] = [];
    for (const item of items) prepared.push(await this.prepare(item));
    const tasks = prepared.flatMap((one) => ('task' in one ? [one.task] : []));
    const verified = tasks.length === 0 ? [] : await this.threads.replay(tasks);
    let next = 0;
    return prepared.map((one) => ('task' in one ? one.complete(verified[next++]) : one.report));
  }

  private async prepare(item: PlayItem): Promise<Prepared> {
    const { file, line, id, content } = item;
    const place = { version: 1, file, line, id } as const;
    const unread = (verdict: VerifyReport['verdict'], message: string): Prepared => ({
      report: { ...place, verdict, message, level: null, engine: null, accuracy: null, claim: null, ...NOTHING },
    });
    if (!(content instanceof Uint8Array)) return unread(content.verdict, content.why);
    const decoded = decodePlay(content);
    if (!decoded.ok) return unread(decoded.verdict, decoded.message);
    const { play } = decoded;
    const { engine, accuracy, claim } = play;
    const report = (
      verdict: VerifyReport['verdict'],
      message: string,
      known: KnownLevel | null,
      rest: Pick<VerifyReport, keyof typeof NOTHING> = NOTHING,
      mayBe: KnownLevel | null = null,
    ): VerifyReport => {
      const level = { hash: play.level, file: known?.file ?? null, name: known?.name ?? null, mayBe: mayBe?.file ?? null };
      return { ...place, verdict, message, level, engine, accuracy, claim, ...rest };
    };
    const older = engine === ownEngine.id ? null : await this.olderEngine(engine);
    if (engine !== ownEngine.id && older === null) {
      return { report: report('unknown-engine', this.unknownEngine(engine), this.catalogue.find(play.level)) };
    }
    const known = (older?.catalogue ?? this.catalogue).find(play.level);
    if (known === null) {
      const candidate = older === null ? this.candidate(play) : null;
      return { report: report('stale-level', this.stale(candidate), null, NOTHING, candidate?.known) };
    }
    // asked here, since an older engine may not know that it has to ask
    const other = whyOtherAccuracy(play, this.settings.accuracy);
    if (other !== null) return { report: report(other.verdict, other.message, known) };
    return {
      task: {
        bytes: content,
        level: { file: known.file, hash: known.hash },
        rules: this.settings.rules,
        engine: older === null ? null : { id: engine, folder: older.folder },
        options: { ...this.settings.options, accuracy: 'any', challengeSubject: item.subject ?? undefined },
      },
      complete(verified) {
        if (verified === null) return report('stale-level', `${known.file} has changed since gq began to verify`, known);
        const { verdict, message, found, differs, challenge, signs, ending } = verified;
        return report(verdict, message, known, { found, time: ending?.time ?? null, differs, challenge, signs });
      },
    };
  }

  private candidate(play: Play) {
    if (this.candidatesLeft === 0) return null;
    this.candidatesLeft--;
    return candidateFor(play, this.catalogue.levels);
  }

  private stale(candidate: Candidate | null): string {
    const { length } = this.catalogue.levels;
    const found = `no level among ${length === 1 ? 'the one' : `the ${length}`} given has the hash of the play`;
    if (candidate === null) return `${found}: it was played on another version of a level, or on another level`;
    const { known, isExact } = candidate;
    return `${found}; its inputs ${isExact ? 'lead to just what it claims on' : 'end alike on'} ${known.file}, which may be another version of its level`;
  }

  private unknownEngine(engine: string): string {
    const found = `expected a play of engine ${ownEngine.id}, found one of ${engine}`;
    const { engines } = this.settings;
    if (engines === null) return `${found}; --engines DIR looks up older ones`;
    const known = this.engines.size === 0 ? 'no engine' : `engine ${[...this.engines.keys()].join(', ')}`;
    return `${found}; ${engines} has ${known}`;
  }

  /** The older engine with this identity, read once; null if there is none. */
  private async olderEngine(id: string): Promise<OlderEngine | null> {
    const folder = this.engines.get(id);
    if (folder === undefined) return null;
    const loading = this.older.get(id) ?? this.load(id, folder);
    this.older.set(id, loading);
    return loading;
  }

  private async load(id: string, folder: string): Promise<OlderEngine> {
    const { files, rules } = this.settings;
    return { catalogue: readCatalogue(files, rules, await loadEngine(folder, id)), folder };
  }
}

/** Plays that are verified together. */
const BATCH = 32;

/**
 * Verifies plays as they come, several batches at once, and keeps their order.
 * @param groups plays that arrive together: none of them waits for the next group
 * @param take receives reports; false: nobody wants more of them
 */
export async function verifyInOrder(
  groups: AsyncIterable<readonly PlayItem[]> | Iterable<readonly PlayItem[]>,
  desk: PlayDesk,
  most: number,
  take: (reports: readonly VerifyReport[]) => Promise<boolean>,
): Promise<void> {
  const underWay: Promise<boolean>[] = [];
  let last: Promise<boolean> = Promise.resolve(true);
  for await (const group of groups) {
    for (let i = 0; i < group.length; i += BATCH) {
      const oldest = underWay.length < most ? undefined : underWay.shift();
      if (oldest !== undefined && !(await oldest)) return;
      const verified = desk.verify(group.slice(i, i + BATCH));
      const before = last;
      last = (async () => {
        const [goesOn, reports] = await Promise.all([before, verified]);
        return goesOn && (await take(reports));
      })();
      // it is awaited later
      last.catch(() => {});
      underWay.push(last);
    }
  }
  await last;
}
