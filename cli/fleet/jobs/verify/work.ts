import type { VerifyReport } from '../../../../schema/index.ts';
import type { Entry } from '../../../io/index.ts';
import { deskSettings, itemOf, PlayDesk, type PlayJobSettings, startThreads } from '../../../verify/index.ts';
import { type Json, oneByOne, type Work } from '../../job.ts';

/** Verifies plays. */
export function openVerify(settings: PlayJobSettings): Work {
  // a play that is tried on other levels would depend on how many came before it
  const desk = new PlayDesk(deskSettings(settings, 0), startThreads(1));
  async function verify({ name, content }: Entry): Promise<VerifyRecord> {
    if (!(content instanceof Uint8Array)) return { report: null, why: content.message };
    const [report] = await desk.verify([itemOf(name, content)]);
    return { report, why: null };
  }
  return {
    work: oneByOne(async (entry) => (await verify(entry)) as unknown as Json),
    async replay(entry, result) {
      const again = await verify(entry);
      if (JSON.stringify(again) === JSON.stringify(result)) return null;
      const { report, why } = again;
      return report === null ? why! : report.verdict === 'ok' ? 'ok, but not as recorded' : report.verdict;
    },
  };
}

/** What has become of a play. */
export interface VerifyRecord {
  /** null: it could not be verified. */
  readonly report: VerifyReport | null;
  /** Why it could not; null if it could. */
  readonly why: string | null;
}
