const LABELS: Readonly<Record<string, string>> = { vx: 'speed x', vy: 'speed y', description: 'about' };

/** How a property is called where it is typed. */
export const labelOf = (key: string): string => LABELS[key] ?? key;
