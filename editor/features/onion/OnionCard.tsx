import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import type { OnCanvas } from '../../canvas/index.ts';
import { useEditor, useLevel, useSession } from '../../core/context/index.ts';
import type { Rect } from './card-position.ts';
import { changedObjects } from './changed-objects.ts';
import type { FormerRun } from './former.ts';
import { onionSessionOf } from './onion-session.ts';
import { onionOf } from './onion-store.ts';
import { placesOnPage } from './places-on-page.ts';
import { type Difference, rowsOf, whyUnknown } from './rows.ts';
import { type Surroundings, useCardPlace } from './use-card-position.ts';
import { useFigures } from './use-figures.ts';
import { useOnionEvents } from './use-onion-events.ts';
import './onion.css';

/** A sign and a word for each difference, so that colour is not the only one. */
const SIGNS: Readonly<Record<Difference, readonly [sign: string, word: string]>> = {
  better: ['▲', 'better'],
  worse: ['▼', 'worse'],
  same: ['=', 'same'],
  other: ['≠', 'different'],
  unknown: ['?', 'not known'],
};

interface CardProps {
  readonly former: FormerRun;
  /** Where objects of the level are on the page; without any, the corner of the canvas. */
  readonly whereAre: (keys: readonly string[]) => Rect;
  /** Points of the way of the shown run, px of the page. */
  readonly wayOnPage: Surroundings['way'];
}

/** The differences between the run before a change and the shown run, beside the pointer or the changed objects. */
export function OnionCard({ host, canvas }: OnCanvas) {
  const level = useLevel();
  const onion = onionSessionOf(useEditor(), level);
  const store = onionOf(level);
  const places = useMemo(() => placesOnPage(level, { host, canvas }), [level, host, canvas]);
  const former = useStore(store, (state) => state.former);
  const said = useStore(store, (state) => state.said);
  const isEdited = useSession(({ mode }) => mode === 'edit');
  useOnionEvents(onion);
  return (
    <>
      {former !== null && isEdited && <Card former={former} {...places} />}
      <p className="unseen" role="status" aria-label="Before and after">
        {said}
      </p>
    </>
  );
}

function Card({ former, whereAre, wayOnPage }: CardProps) {
  const level = useLevel();
  const { phase, slack, slackNow } = useStore(onionOf(level));
  const figures = useFigures(phase === 'held');
  const rows = rowsOf(former.figures, figures, { before: slack, now: slackNow });
  const unknown = whyUnknown(former.figures, figures);
  const card = useRef<HTMLDivElement>(null);
  const around = useMemo(
    () => ({
      objects() {
        const changed = changedObjects(former.file, level.document.file());
        return whereAre(changed.flatMap(({ key, is }) => (is === null ? [] : [key])));
      },
      way: wayOnPage,
    }),
    [former, level, whereAre, wayOnPage],
  );
  useCardPlace(card, phase, around);
  return (
    <div ref={card} className="onion" role="note" aria-label="Before and after the change">
      <p className="onion__head">before → after</p>
      <dl className="onion__rows numbers">
        {rows.map(({ label, before, after, by, difference }) => {
          const [sign, word] = SIGNS[difference];
          return (
            <div key={label} className={`onion__row onion__row--${difference}`}>
              <span className="onion__sign" aria-hidden>
                {sign}
              </span>
              <dt>{label}</dt>
              <dd>
                {before === after || difference === 'same' ? after : `${before} → ${after}`}
                {by !== '' && (
                  <>
                    , <b>{by}</b>
                  </>
                )}
                <span className="unseen">, {word}</span>
              </dd>
            </div>
          );
        })}
      </dl>
      {unknown !== null && <p className="onion__note">{unknown}</p>}
    </div>
  );
}
