import { CircleCheck, CircleHelp, CircleX, Undo2 } from 'lucide-react';
import { useStore } from 'zustand';
import type { LevelVerdict } from '../../check/index.ts';
import { VERDICT_MEANS } from '../../check/words/index.ts';
import { useDocument, useEditor, useLevel, usePageTerms, useProof } from '../core/context/index.ts';
import { plural } from '../core/figures/index.ts';
import { endInWords } from '../core/proof/index.ts';
import { isOtherAccuracy, termsInWords } from '../core/terms/index.ts';
import { Button, Hint } from '../core/ui/index.ts';
import { useVerdict } from '../core/verdict/index.ts';

const LOOKS = {
  completable: { Icon: CircleCheck, text: 'completable' },
  broken: { Icon: CircleX, text: 'broken' },
  unproven: { Icon: CircleHelp, text: 'unproven' },
  impossible: { Icon: CircleX, text: 'impossible' },
} as const;

/** A level in which a merge left conflicts, whatever its runs do. */
const UNDECIDED = { Icon: CircleX, text: 'invalid' } as const;

/** How many ticks all presses and releases of the shown run may slip at once, as far as it is known. */
function Slack() {
  const { analysis: store } = useLevel();
  const analysis = useStore(store);
  const holds = useProof((proof) => proof.run.holds.join());
  if (analysis === null || analysis.holds !== holds) return null;
  const { certifiedTicks: ticks, decided, p40 } = analysis;
  const isThin = ticks === 0 && decided;
  const chance = `${Math.round(100 * p40)} %`;
  const words = ticks === null ? 'slack …' : isThin ? 'thin' : `slack ${ticks}${decided ? '' : '+'}`;
  const certificate =
    ticks === null
      ? 'Certifying how far all presses and releases may slip at once…'
      : isThin
        ? 'If all presses and releases slip by up to one tick, the run can fail.'
        : `Certified: all presses and releases may slip by ${plural(ticks, 'tick')} at once.${decided ? '' : ' Larger slips were too many to check.'}`;
  return (
    <Hint text={`${certificate} With timing noise of 40 ms the run succeeds ${chance} of the time.`}>
      <output className={isThin ? 'topbar__forgives topbar__forgives--thin' : 'topbar__forgives'} aria-label="Slack">
        {words}
        <span className="topbar__chance"> · {chance}</span>
      </output>
    </Hint>
  );
}

/** @param run the run that completes the level; null: only a worker knows which one */
const provenInWords = (run: string | null): string =>
  run === null ? 'one of its runs reaches the black hole' : `the run "${run}" reaches the black hole`;

/** @param reason why the verdict holds */
const meaningOf = (verdict: Exclude<LevelVerdict, 'completable'>, reason: string | null): string =>
  reason === null ? VERDICT_MEANS[verdict] : `${VERDICT_MEANS[verdict]}: ${reason}`;

/**
 * The verdict that `gq check` would give for what is on the screen, live. At another accuracy than that of the folder, it says so.
 */
export function VerdictBadge() {
  const { verdict, reason, limit } = useVerdict(useLevel());
  const provenBy = useProof((proof) => proof.provenBy);
  const taken = useProof((proof) => proof.run.minerals.length);
  const minerals = useProof((proof) => proof.level.minerals.length);
  const shown = useProof((proof) => proof.run.name);
  const ends = useProof(endInWords);
  const isUndecided = useDocument(({ file }) => (file.conflicts ?? []).length > 0);
  const terms = usePageTerms();
  const under = isOtherAccuracy(terms) ? `, ${termsInWords(terms)}` : '';
  const { Icon, text } = isUndecided ? UNDECIDED : LOOKS[verdict];
  const why = isUndecided
    ? 'A merge left conflicts in it'
    : (limit ?? (verdict === 'completable' ? provenInWords(provenBy) : meaningOf(verdict, reason)));
  return (
    <>
      <Hint text={`${why}${under}. Shown: ${shown === null ? 'no run, she drifts' : `"${shown}"`}, ${ends}`}>
        <output className={`badge badge--${isUndecided ? 'broken' : verdict}`} aria-label={`Verdict: ${text}${under}`}>
          <Icon size={15} aria-hidden />
          {text}
        </output>
      </Hint>
      <AccuracySign isShort />
      <Slack />
      {minerals > 0 && (
        <output className="topbar__forgives numbers" aria-label={`Minerals taken: ${taken} of ${minerals}`}>
          <span className="topbar__sign" aria-hidden>
            ◆
          </span>
          <span className="topbar__unit">minerals </span>
          {taken}/{minerals}
        </output>
      )}
    </>
  );
}

/**
 * Says so while the level is shown at another accuracy than that of the folder, and leads back to it.
 * @param isShort beside the verdict, where there is little room
 */
export function AccuracySign({ isShort = false }: { readonly isShort?: boolean }) {
  const { settings } = useEditor();
  const terms = usePageTerms();
  if (!isOtherAccuracy(terms)) return null;
  const { folder, shown } = terms;
  return (
    <Button
      hint={`The level is shown ${termsInWords(terms)}. Return to ${folder.accuracy.name}`}
      look="outlined"
      icon={<Undo2 size={13} />}
      onClick={() => settings.setState({ otherAccuracy: null })}
    >
      {isShort ? `at ${shown.accuracy.name}` : termsInWords(terms)}
    </Button>
  );
}
