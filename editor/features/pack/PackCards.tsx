import { type KeyboardEvent, type MouseEvent, type RefObject, useLayoutEffect, useRef } from 'react';
import { useStore } from 'zustand';
import type { Terms } from '../../../engine/index.ts';
import { useEditor } from '../../core/context/index.ts';
import { type ListedVerdict, thumbnailsOf, verdictOf } from '../../core/levels/index.ts';
import { toggledIn } from '../../core/tree/index.ts';
import { ChapterHead } from './ChapterHead.tsx';
import { spotAfter } from './card-order.ts';
import { PackCard } from './PackCard.tsx';
import type { Card, Chapter } from './pack-model.ts';
import { useCardDrag } from './use-card-drag.ts';

/** What is selected, and the card that keys act on. */
export interface Selection {
  readonly keys: ReadonlySet<string>;
  readonly active: string | null;
}

interface PackCardsProps {
  readonly chapters: readonly Chapter[];
  /** Those that pass the filter. */
  readonly shown: readonly Card[];
  readonly terms: Terms;
  readonly isFiltered: boolean;
  readonly canMove: boolean;
  readonly canEdit: boolean;
  readonly selection: Selection;
  /** The key of the card that gets the focus once it is there. */
  readonly focus: RefObject<string | null>;
  readonly onSelect: (selection: Selection) => void;
  readonly onOpen: (card: Card) => void;
  /** Called with the pressed key when Alt and a key move the selection. @returns whether it is one of them */
  readonly onMoveKey: (key: string) => boolean;
  readonly onDrop: (keys: ReadonlySet<string>, before: number) => void;
  readonly onRenameChapter: (place: number, name: string) => void;
  readonly onRemoveChapter: (place: number) => void;
}

const ARROWS = ['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End'];

/** The verdict that a card shows. */
export const useVerdictOf = (terms: Terms): ((card: Card) => ListedVerdict) => {
  const { store } = thumbnailsOf(useEditor());
  const made = useStore(store);
  return ({ entry }) => {
    if (entry === null) return 'invalid';
    return entry.status === 'valid' ? (verdictOf(made, entry, terms) ?? 'unknown') : entry.status;
  };
};

/** The cards of all levels in order, below the headings of their chapters. */
export function PackCards(props: PackCardsProps) {
  const { chapters, shown, terms, isFiltered, canMove, canEdit, selection, focus } = props;
  const { onSelect, onOpen, onMoveKey, onDrop, onRenameChapter, onRemoveChapter } = props;
  const box = useRef<HTMLDivElement>(null);
  const verdictOfCard = useVerdictOf(terms);
  const passing = new Set(shown.map(({ key }) => key));
  const active = shown.find(({ key }) => key === selection.active)?.key ?? shown[0]?.key ?? null;
  const taken = useRef<ReadonlySet<string>>(new Set());
  const wasFocused = useRef(false);

  const take = (key: string): ReadonlySet<string> => {
    taken.current = selection.keys.has(key) ? selection.keys : new Set([key]);
    onSelect({ keys: taken.current, active: key });
    return taken.current;
  };
  const { held, drop, listeners, wasDrag } = useCardDrag({
    canMove,
    onTake: take,
    onDrop: (before) => onDrop(taken.current, before),
  });

  // before anything else looks at the focus: a card that moves to another chapter is another element
  useLayoutEffect(() => {
    const element = focus.current === null ? null : cardElement(box.current, focus.current);
    if (element === null) return;
    focus.current = null;
    element.focus({ preventScroll: true });
    // the view opens at its top, with the curve and the problems
    if (wasFocused.current) element.scrollIntoView({ block: 'nearest' });
    wasFocused.current = true;
  });

  const between = (a: string | null, b: string): Set<string> => {
    const [from, to] = [a ?? b, b].map((key) => shown.findIndex((card) => card.key === key)).sort((x, y) => x - y);
    return new Set(shown.slice(Math.max(0, from), to + 1).map(({ key }) => key));
  };
  const onClick = (event: MouseEvent<HTMLDivElement>) => {
    const key = keyOf(event.target);
    if (key === null || wasDrag()) return;
    const mod = event.ctrlKey || event.metaKey;
    const keys = event.shiftKey ? between(selection.active, key) : mod ? toggledIn(selection.keys, key) : new Set([key]);
    onSelect({ keys, active: event.shiftKey ? (selection.active ?? key) : key });
  };
  const walk = (event: KeyboardEvent, key: string) => {
    const elements = [...(box.current?.querySelectorAll<HTMLElement>('[data-key]') ?? [])];
    const spots = elements.map((element) => element.getBoundingClientRect());
    const from = elements.findIndex((element) => element.dataset.key === key);
    const next = elements[spotAfter(spots, from, event.key)];
    const to = next?.dataset.key;
    if (to === undefined) return;
    next.focus();
    next.scrollIntoView({ block: 'nearest' });
    const keys = event.shiftKey ? new Set([...selection.keys, key, to]) : event.ctrlKey ? selection.keys : new Set([to]);
    onSelect({ keys, active: to });
  };
  const onKeyDown = (event: KeyboardEvent<HTMLDivElement>) => {
    const key = event.target instanceof Element && event.target.getAttribute('role') === 'option' ? keyOf(event.target) : null;
    if (key === null) return;
    const card = shown.find((one) => one.key === key);
    const mod = event.ctrlKey || event.metaKey;
    if (event.altKey) {
      if (!ARROWS.includes(event.key) || !onMoveKey(event.key)) return;
    } else if (ARROWS.includes(event.key)) walk(event, key);
    else if (event.key === ' ') onSelect({ keys: toggledIn(selection.keys, key), active: key });
    else if (event.key === 'Enter' && card !== undefined) onOpen(card);
    else if (mod && event.key.toLowerCase() === 'a') onSelect({ keys: new Set(passing), active: key });
    else return;
    event.preventDefault();
  };

  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the cards have the focus; their events are handled in one place
    <div
      ref={box}
      className={`pack__cards${held === null ? '' : ' pack__cards--dragging'}`}
      onClick={onClick}
      onDoubleClick={(event) => {
        const card = shown.find((one) => one.key === keyOf(event.target));
        if (card !== undefined) onOpen(card);
      }}
      onKeyDown={onKeyDown}
      {...listeners}
    >
      {chapters.map((chapter, i) => {
        const cards = chapter.cards.filter(({ key }) => passing.has(key));
        if (isFiltered && cards.length === 0) return null;
        const title = chapter.isUnlisted ? 'Not listed' : (chapter.name ?? (i === 0 ? 'Levels' : 'More levels'));
        return (
          <section key={chapter.key} aria-label={title}>
            <ChapterHead
              chapter={chapter}
              canEdit={canEdit}
              isDrop={drop !== null && drop.at === chapter.place}
              onRename={onRenameChapter}
              onRemove={onRemoveChapter}
            />
            {cards.length === 0 ? (
              <p className="pack__empty">No level stands below this heading yet: move one here.</p>
            ) : (
              <div className="pack__list" role="listbox" aria-multiselectable aria-label={title}>
                {cards.map((card) => (
                  <PackCard
                    key={card.key}
                    card={card}
                    terms={terms}
                    verdict={verdictOfCard(card)}
                    isSelected={selection.keys.has(card.key)}
                    isActive={card.key === active}
                    isHeld={held?.has(card.key) === true}
                    drop={drop?.at === card.place ? drop.side : null}
                    canMove={canMove}
                  />
                ))}
              </div>
            )}
          </section>
        );
      })}
    </div>
  );
}

/** The key of the card that an element belongs to; null if it belongs to none. */
const keyOf = (target: EventTarget | null): string | null =>
  target instanceof Element ? (target.closest<HTMLElement>('[data-key]')?.dataset.key ?? null) : null;

/** The element of a card. */
export const cardElement = (within: ParentNode | null, key: string): HTMLElement | null =>
  [...(within?.querySelectorAll<HTMLElement>('[data-key]') ?? [])].find((element) => element.dataset.key === key) ?? null;
