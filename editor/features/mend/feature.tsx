import { Wrench, X } from 'lucide-react';
import { useEffect, useRef } from 'react';
import { useStore } from 'zustand';
import { type Mended, mendedInWords } from '../../../check/index.ts';
import { plural } from '../../../check/words/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { useLevel } from '../../core/context/index.ts';
import { seconds } from '../../core/figures/index.ts';
import { Offer, Progress } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { aliveOf } from '../alive/index.ts';
import type { Feature } from '../feature.ts';
import { MEND_KEY, type MendSession, type MendState, mendSessionOf, watchMend } from './watch-mend.ts';
import './mend.css';

/** What mends the level after a change that broke it. */
export const mend: Feature = {
  name: 'mend',
  offer: MendCard,
  commands({ open }) {
    /** What offers to mend the level; null if nothing does. */
    const offered = () => {
      const level = open.getState();
      const found = level === null ? null : mendSessionOf(level);
      return found === null || found.store.getState().phase === 'none' ? null : found;
    };
    const needsBroken = () => (open.getState() === null ? 'open a level first' : 'change something that breaks the level first');
    return [
      {
        id: 'level.mend',
        title: 'Mend what the last change broke',
        group: 'Solve',
        keys: [MEND_KEY],
        needs: () => (offered() === null ? needsBroken() : null),
        run: () => offered()?.start(),
      },
      {
        id: 'level.mend-dismiss',
        title: 'Leave broken what the last change broke',
        group: 'Solve',
        keys: ['Escape'],
        needs: () => (offered() === null ? 'nothing is offered to mend' : null),
        run: () => offered()?.leave(),
      },
    ];
  },
  open: ({ session, settings, desk }, level) => watchMend({ level, session, settings, desk, alive: aliveOf(level) }),
};

/** The offer to mend what the last change broke: a sentence over the canvas, and what was found once it is asked for. */
function MendCard() {
  const own = mendSessionOf(useLevel());
  return own === null ? null : <Card own={own} />;
}

function Card({ own }: { readonly own: MendSession }) {
  const state = useStore(own.store);
  const { phase, sentence, mending, previewed, after } = state;
  const card = useRef<HTMLElement>(null);
  const isAsked = phase === 'seeking' || phase === 'done' || phase === 'failed';
  // the key starts it from anywhere
  useEffect(() => {
    if (isAsked && !card.current?.contains(document.activeElement)) card.current?.focus();
  }, [isAsked]);
  return (
    <section
      ref={card}
      className={phase === 'none' ? 'mend mend--none' : 'mend'}
      aria-label="Mend"
      tabIndex={-1}
      // also while the tooltip of a focused button takes Escape
      onKeyDown={(event) => {
        if (event.key !== 'Escape' || phase === 'none') return;
        event.preventDefault();
        own.leave();
      }}
    >
      <div className="mend__head">
        <p className="mend__said" role="status">
          {sentence}
        </p>
        {phase === 'offered' && (
          <Button
            hint="Find what mends the level"
            shortcut="Shift M"
            icon={<Wrench size={14} />}
            look="outlined"
            onClick={own.start}
          >
            Mend
          </Button>
        )}
        {phase !== 'none' && <Button hint="Dismiss" shortcut="Esc" icon={<X size={14} />} onClick={own.dismiss} />}
      </div>
      {isAsked && (
        <>
          <Progress label="Seeking what mends the level" isRunning={phase === 'seeking'} />
          {mending !== null && after !== null && mending.found.length > 0 && (
            <ol className="mend__finds" aria-label="What mends the level">
              {/* only one of them while it is previewed: the canvas is what matters then */}
              {(previewed === null ? mending.found : [previewed]).map((mended) => (
                <Find key={mendedInWords(mended, after)} own={own} mended={mended} after={after} isShown={previewed !== null} />
              ))}
            </ol>
          )}
          <p className="part__note" role="status">
            {summaryOf(state)}
          </p>
        </>
      )}
    </section>
  );
}

interface FindProps {
  readonly own: MendSession;
  readonly mended: Mended;
  readonly after: LevelFile;
  readonly isShown: boolean;
}

function Find({ own, mended, after, isShown }: FindProps) {
  const { run, time, slack } = mended;
  const forgives = slack === null ? '' : `, slack ${plural(slack, 'tick')}`;
  return (
    <Offer
      text={mendedInWords(mended, after)}
      figures={`run ${JSON.stringify(run)}: ${seconds(time)}${forgives}`}
      isShown={isShown}
      onPreview={() => own.preview(mended)}
      onBack={own.back}
      onTake={own.take}
    />
  );
}

/** What the search for what mends the level says about itself. */
function summaryOf({ phase, mending }: MendState): string {
  const found = mending?.found.length ?? 0;
  if (phase === 'failed') return 'Seeking failed. Try again, or undo the change.';
  if (phase === 'seeking') return found === 0 ? 'Seeking what mends the level.' : 'More is sought.';
  if (found === 0) return 'Nothing was found. This does not prove that there is nothing: undo takes the change back.';
  return 'Each is the smallest that was tried of its kind.';
}
