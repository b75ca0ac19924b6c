import { ArrowUpRight, FileX, GripVertical, Sparkle } from 'lucide-react';
import { memo } from 'react';
import { useStore } from 'zustand';
import type { Terms } from '../../../engine/index.ts';
import { useEditor, usePageTheme } from '../../core/context/index.ts';
import { seconds } from '../../core/figures/index.ts';
import { type ListedVerdict, pictureOf, thumbnailsOf, VerdictSign } from '../../core/levels/index.ts';
import type { Card } from './pack-model.ts';

interface PackCardProps {
  readonly card: Card;
  readonly terms: Terms;
  readonly verdict: ListedVerdict;
  readonly isSelected: boolean;
  /** Whether it is the one that Tab leads to. */
  readonly isActive: boolean;
  readonly isHeld: boolean;
  /** The edge at which dragged cards would be dropped. */
  readonly drop: 'before' | 'after' | null;
  readonly canMove: boolean;
}

/** A level of the pack: picture, number, verdict, grade, length, minerals, what it introduces. */
export const PackCard = memo(function PackCard(props: PackCardProps) {
  const { card, terms, verdict, isSelected, isActive, isHeld, drop, canMove } = props;
  const { entry, facts, grade, introduces, jump, number, id, place } = card;
  const classes = [
    'pack__card',
    isSelected ? 'pack__card--selected' : '',
    isHeld ? 'pack__card--held' : '',
    drop === null ? '' : `pack__card--${drop}`,
  ];
  return (
    <div
      role="option"
      aria-selected={isSelected}
      tabIndex={isActive ? 0 : -1}
      className={classes.filter((name) => name !== '').join(' ')}
      data-key={card.key}
      data-place={place}
    >
      {/* what it shows is said in words below */}
      <div className="pack__picture" aria-hidden>
        {entry === null ? <FileX size={22} aria-hidden /> : <Picture card={card} terms={terms} />}
        {grade !== null && grade.value !== null && (
          <span className={`pack__grade numbers${grade.isOld ? ' pack__grade--old' : ''}`}>
            {grade.value.toFixed(1)}
            {grade.isOld ? ' old' : ` ${grade.word}`}
          </span>
        )}
        {canMove && (
          <span className="pack__grip" data-grip>
            <GripVertical size={16} />
          </span>
        )}
      </div>
      <div className="pack__line">
        <span className="pack__number numbers">{number}</span>
        <span className="pack__name" title={entry?.file ?? id}>
          {entry?.name ?? id}
        </span>
      </div>
      <div className="pack__facts">
        {entry === null ? <span className="verdict verdict--invalid">no such level</span> : <VerdictSign verdict={verdict} />}
        <GradeInWords card={card} />
        {facts != null && facts.seconds !== null && <span className="numbers">{seconds(facts.seconds)}</span>}
        {facts != null && facts.mineralCount > 0 && (
          <span className="numbers">
            {facts.minerals} of {facts.mineralCount} minerals
          </span>
        )}
      </div>
      {(introduces.length > 0 || jump !== null) && (
        <div className="pack__chips">
          {introduces.map((effect) => (
            <span key={effect} className="pack__chip">
              <Sparkle size={10} aria-hidden />
              new: {effect}
            </span>
          ))}
          {jump !== null && (
            <span className="pack__chip pack__chip--jump">
              <ArrowUpRight size={11} aria-hidden />
              jump +{jump.toFixed(1)}
            </span>
          )}
        </div>
      )}
    </div>
  );
});

function GradeInWords({ card: { grade } }: Pick<PackCardProps, 'card'>) {
  if (grade === null) return null;
  if (grade.value === null) return <span>{grade.word}</span>;
  return (
    <span className="unseen">
      grade {grade.value.toFixed(1)} {grade.word}
      {grade.isOld && ', before the last change'}
    </span>
  );
}

function Picture({ card: { entry }, terms }: Pick<PackCardProps, 'card' | 'terms'>) {
  const editor = useEditor();
  const theme = usePageTheme();
  const url = useStore(thumbnailsOf(editor).store, (made) => (entry === null ? null : pictureOf(made, entry, theme, terms)));
  if (entry !== null && entry.status !== 'valid') return <FileX size={22} aria-hidden />;
  return url === null ? null : <img src={url} alt="" draggable={false} />;
}
