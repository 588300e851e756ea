/* Section 4 of docs/reference/adapter.md, on functions that cores with float arithmetic share. */

static int numbers_are_scaled_with_twice_the_digits_of_a_float(void)
{
    HOLDS(Sigcat_Scaled(3.0F, 0.0F, 2.0F, 0.0F, 0.5F, 0.0F) == 6.5F);
    HOLDS(Sigcat_Scaled(76686.766F, 0.0F, -17.360987F, 4.1368386e-07F, 1331368.5F, 0.03795645F) == 10.650863F);
    HOLDS(Sigcat_Scaled(16890.828F, 0.0F, 21.488317F, -8.4829435e-07F, -362957.66F, 0.0154329445F) == -2.1777327F);
    HOLDS(Sigcat_Scaled(3945.9185F, 0.0F, -14.007815F, -4.491122e-07F, 37349.0F, 0.0F) == -17924.7F);
    HOLDS(Sigcat_Scaled(2274109400.0F, 29.0F, -2.9185016F, 5.0576494e-09F, 6637012000.0F, 90.63039F) == 19910.977F);
    HOLDS(Sigcat_Scaled(1382686300.0F, -56.0F, 14.809707F, 3.9592717e-07F, -20477240000.0F, -931.2007F) == -61431.535F);
    HOLDS(Sigcat_Scaled(1617910900.0F, -26.0F, -8.220824F, 3.8068603e-07F, 19809.285F, 0.00055803574F) == -13300540000.0F);
    HOLDS(Sigcat_Scaled(3e38F, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F) > FLT_MAX);
    HOLDS(Sigcat_Scaled(-3e38F, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F) < -FLT_MAX);
    HOLDS(Sigcat_Scaled(1.5e38F, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F) == 3e38F);
    HOLDS(Sigcat_Scaled(-1.5e38F, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F) == -3e38F);
    HOLDS(isnan(Sigcat_Scaled(NAN, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F)));
    HOLDS(isinf(Sigcat_Scaled(INFINITY, 0.0F, 2.0F, 0.0F, 1.0F, 0.0F)));
    return 0;
}

static int an_integer_is_a_float_and_a_rest(void)
{
    HOLDS(Sigcat_RestOfInt32(INT32_MAX) == -1.0F && Sigcat_RestOfInt32(INT32_MIN) == 0.0F);
    HOLDS(Sigcat_RestOfInt32(16777217) == 1.0F && Sigcat_RestOfInt32(-16777217) == -1.0F);
    HOLDS(Sigcat_RestOfUint32(UINT32_MAX) == -1.0F && Sigcat_RestOfUint32(16777219U) == -1.0F);
    return 0;
}

static int converted_numbers_are_rounded_once(void)
{
    HOLDS(numbers_are_scaled_with_twice_the_digits_of_a_float() == 0 && an_integer_is_a_float_and_a_rest() == 0);
    HOLDS(Sigcat_ToFloat(INFINITY, 1.0F) == FLT_MAX && Sigcat_ToFloat(-INFINITY, 1.0F) == -FLT_MAX);
    HOLDS(Sigcat_ToFloat(INFINITY, FLT_MAX) == FLT_MAX && Sigcat_ToFloat(-INFINITY, -FLT_MAX) == -FLT_MAX);
    HOLDS(isinf(Sigcat_ToFloat(INFINITY, INFINITY)) && Sigcat_ToFloat(INFINITY, INFINITY) > 0.0F);
    HOLDS(isinf(Sigcat_ToFloat(-INFINITY, INFINITY)) && Sigcat_ToFloat(-INFINITY, INFINITY) < 0.0F);
    HOLDS(isinf(Sigcat_ToFloat(INFINITY, -INFINITY)) && isinf(Sigcat_ToFloat(-INFINITY, -INFINITY)));
    HOLDS(isnan(Sigcat_ToFloat(NAN, NAN)) && Sigcat_ToFloat(0.1F, 1.0F) == 0.1F);
    HOLDS(Sigcat_ToFloat(FLT_MAX, 1.0F) == FLT_MAX && Sigcat_ToFloat(-FLT_MAX, 1.0F) == -FLT_MAX);
    HOLDS(Sigcat_QuietFloat(2.0F) == 2.0F && isnan(Sigcat_QuietFloat(NAN)));
    return 0;
}

static int ties_go_to_the_even_integer(void)
{
    HOLDS(Sigcat_ToInt8(0.5F, 9) == 0 && Sigcat_ToInt8(1.5F, 9) == 2 && Sigcat_ToInt8(2.5F, 9) == 2);
    HOLDS(Sigcat_ToInt8(-0.5F, 9) == 0 && Sigcat_ToInt8(-1.5F, 9) == -2 && Sigcat_ToInt8(-2.5F, 9) == -2);
    HOLDS(Sigcat_ToInt8(0.51F, 9) == 1 && Sigcat_ToInt8(0.49F, 9) == 0);
    HOLDS(Sigcat_ToInt8(-0.51F, 9) == -1 && Sigcat_ToInt8(-0.49F, 9) == 0);
    HOLDS(Sigcat_ToUint8(0.5F, 9U) == 0U && Sigcat_ToUint8(1.5F, 9U) == 2U);
    HOLDS(Sigcat_ToInt32(8388607.5F, 9) == 8388608 && Sigcat_ToInt32(-8388607.5F, 9) == -8388608);
    HOLDS(Sigcat_ToInt32(8388609.0F, 9) == 8388609 && Sigcat_ToInt32(-8388609.0F, 9) == -8388609);
    return 0;
}

static int integers_saturate(void)
{
    HOLDS(Sigcat_ToInt8(-129.0F, 9) == -128 && Sigcat_ToInt8(128.0F, 9) == 127 && Sigcat_ToInt8(NAN, 9) == 9);
    HOLDS(Sigcat_ToInt8(-128.0F, 9) == -128 && Sigcat_ToInt8(127.0F, 9) == 127 && Sigcat_ToInt8(126.4F, 9) == 126);
    HOLDS(Sigcat_ToInt16(-32769.0F, 9) == -32768 && Sigcat_ToInt16(32768.0F, 9) == 32767);
    HOLDS(Sigcat_ToInt32(-3e9F, 9) == INT32_MIN && Sigcat_ToInt32(2147483648.0F, 9) == INT32_MAX);
    HOLDS(Sigcat_ToInt32(2147483520.0F, 9) == 2147483520 && Sigcat_ToInt32(-2147483520.0F, 9) == -2147483520);
    HOLDS(Sigcat_ToInt64(-1e19F, 9) == INT64_MIN && Sigcat_ToInt64(1e19F, 9) == INT64_MAX);
    HOLDS(Sigcat_ToInt64(2.5F, 9) == 2 && Sigcat_ToInt64(NAN, 9) == 9);
    HOLDS(Sigcat_ToUint8(-1.0F, 9U) == 0U && Sigcat_ToUint8(256.0F, 9U) == 255U);
    HOLDS(Sigcat_ToUint8(NAN, 9U) == 9U && Sigcat_ToUint8(254.0F, 9U) == 254U);
    HOLDS(Sigcat_ToUint16(65536.0F, 9U) == 65535U && Sigcat_ToUint32(4294967296.0F, 9U) == UINT32_MAX);
    HOLDS(Sigcat_ToUint32(4294967040.0F, 9U) == 4294967040U);
    HOLDS(Sigcat_ToUint64(-1.0F, 9U) == 0U && Sigcat_ToUint64(1e20F, 9U) == UINT64_MAX);
    HOLDS(Sigcat_ToUint64(9223372036854775808.0F, 9U) == UINT64_C(9223372036854775808));
    HOLDS(Sigcat_ToUint64(3.5F, 9U) == 4U && Sigcat_ToUint64(NAN, 9U) == 9U);
    return 0;
}
