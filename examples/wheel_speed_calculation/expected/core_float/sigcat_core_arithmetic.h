/*
 * The type in which the adapters of a program convert values: float.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_ARITHMETIC_H
#define SIGCAT_CORE_ARITHMETIC_H

#define SIGCAT_FLOAT_ARITHMETIC 1

#endif /* SIGCAT_CORE_ARITHMETIC_H */
