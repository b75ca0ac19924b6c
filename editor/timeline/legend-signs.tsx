import type { ReactNode } from 'react';

/** A sign of the legend as it is written on the timeline: `A2`. */
export const markedAs = (text: string): ReactNode => <span className="legend__mark">{text}</span>;

/** A sign of the legend that is drawn as what it explains. @param name of its look: `legend__look--NAME` in a style sheet */
export const looksLike = (name: string): ReactNode => <span className={`legend__look legend__look--${name}`} />;
